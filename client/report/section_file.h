#pragma once

#include <filesystem>
#include <string>

#include "common/measure/section.h"

namespace burnish {

/// Returns a drawing in SVG: the original grey below the edited surface, with axes in numbers.
std::string section_svg(const Section& section, const std::string& unit);

/// Returns a table with a row per point: surface,line,right,up.
std::string section_csv(const Section& section);

/// Writes the section as its file's ending says. Fails: as writing does.
Status write_section(const Section& section, const std::string& unit,
                     const std::filesystem::path& file);

/// Fails: invalid_argument for an ending that is neither .svg nor .csv.
Status check_section_name(const std::filesystem::path& file);

}  // namespace burnish
