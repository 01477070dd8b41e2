#include "client/model/files/typed_path.h"

#include <cstdlib>

namespace burnish {

std::filesystem::path typed_path(const std::string& text) {
  const char* const home = std::getenv("HOME");
  if (!home || (text != "~" && !text.starts_with("~/"))) return text;
  return text == "~" ? home : std::filesystem::path(home) / text.substr(2);
}

}  // namespace burnish
