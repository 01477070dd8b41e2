#include <algorithm>

#include "common/transfer/content_hash.h"

namespace burnish {

bool is_content_hash(std::string_view text) {
  return text.size() == ContentHash::kDigits && std::all_of(text.begin(), text.end(), [](char c) {
           return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f');
         });
}

}  // namespace burnish
