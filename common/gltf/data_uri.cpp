#include "common/gltf/data_uri.h"

#include <algorithm>
#include <utility>

#include "common/gltf/base64.h"

namespace burnish {

/// Compares a letter of the text with a small one.
static bool is_letter(char c, char small) {
  return c == small || (c >= 'A' && c <= 'Z' && c - 'A' + 'a' == small);
}

bool is_data_uri(std::string_view uri) {
  constexpr std::string_view kScheme = "data:";
  return uri.size() >= kScheme.size() &&
         std::ranges::equal(uri.substr(0, kScheme.size()), kScheme, is_letter);
}

size_t find_base64(std::string_view uri) {
  constexpr std::string_view kMark = ";base64,";
  const std::string_view head = uri.substr(0, std::min(uri.find(','), uri.size() - 1) + 1);
  if (!is_data_uri(uri) || head.size() < kMark.size() ||
      !std::ranges::equal(head.substr(head.size() - kMark.size()), kMark, is_letter))
    return std::string_view::npos;
  return head.size();
}

Result<std::vector<uint8_t>> read_data_uri(std::string_view uri, const std::string& place,
                                           const FileSteps& steps) {
  const size_t begin = find_base64(uri);
  if (begin == std::string_view::npos)
    return invalid_argument(place + ": its data URI is not base64");
  auto decoded = from_base64(uri.substr(begin), steps);
  if (!decoded) return invalid_argument(place + ": its base64 is damaged");
  return std::move(*decoded);
}

}  // namespace burnish
