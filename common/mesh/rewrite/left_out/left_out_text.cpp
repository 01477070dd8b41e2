#include "common/mesh/rewrite/left_out/left_out.h"

namespace burnish {

std::string left_out_text(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

}  // namespace burnish
