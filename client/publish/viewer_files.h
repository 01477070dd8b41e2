#pragma once

#include <filesystem>
#include <string>

#include "common/base/status.h"

namespace burnish {

/// Writes the page's viewer as the program carries it: index.html and what it loads.
/// Fails: unimplemented (a program that was built without the page); as writing does.
Status write_viewer(const std::filesystem::path& folder);

/// Fails: unimplemented, as write_viewer().
Status check_has_viewer();

/// Returns true for names that write_viewer() puts into its folder.
bool is_of_viewer(const std::string& name);

}  // namespace burnish
