#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "common/edit/edit.h"

namespace burnish {

/// Fields of single cells as text, one line `i j k alpha1 alpha2 beta` each: i, j, k in grid units
/// of the depth, α in user units. More words on a line are passed over, so that what --fields-out
/// wrote reads back; '#' begins a comment.
/// Fails: as errno says; invalid_argument naming file, line, value and limit.
Result<SetCellFields> read_cell_field_file(const std::filesystem::path& path);

/// The same from text; `name` serves the messages.
Result<SetCellFields> parse_cell_fields(std::string_view text, const std::string& name);

}  // namespace burnish
