#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "common/edit/edit.h"

namespace burnish {

/// Reads fields of single cells from text lines `i j k alpha1 alpha2 beta`: i, j, k in grid units
/// of the depth, α in user units. Ignores further words on a line, so that files of --fields-out
/// can be read; '#' begins a comment.
/// Fails: as errno says; invalid_argument that names file, line, value and limit.
Result<SetCellFields> read_cell_field_file(const std::filesystem::path& path);

/// Parses the same text from memory; `name` is used in messages.
Result<SetCellFields> parse_cell_fields(std::string_view text, const std::string& name);

}  // namespace burnish
