#pragma once

#include <set>
#include <string>

namespace burnish {

/// Loads the window's fonts for a scale, with these letters besides Latin, Greek and Cyrillic. It
/// looks for fonts of other scripts with fontconfig. Call it between frames.
/// Returns letters of scripts that no font here has; UTF-8, one for each script.
std::string load_fonts(float scale, const std::set<char16_t>& letters);

}  // namespace burnish
