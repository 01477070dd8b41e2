#pragma once

#include <filesystem>
#include <string>

namespace burnish {

/// Returns the path that a user typed, with their home folder for "~" or a leading "~/".
std::filesystem::path typed_path(const std::string& text);

}  // namespace burnish
