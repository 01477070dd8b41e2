#include "client/model/files/typed_path.h"

#include "client/tools/user_folders.h"

namespace burnish {

std::filesystem::path typed_path(const std::string& text) {
  const std::filesystem::path home = home_folder();
  if (home.empty() || (text != "~" && !text.starts_with("~/"))) return text;
  return text == "~" ? home : home / text.substr(2);
}

}  // namespace burnish
