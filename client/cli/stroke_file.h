#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "common/edit/brush.h"

namespace burnish {

/// Strokes as text: each begins with its brush and goes on with the points of its path. Lengths in
/// the scan's units; FALLOFF is smooth, linear, sharp or constant; '#' begins a comment.
///
///     brush RADIUS STRENGTH BETA FALLOFF
///     X Y Z
///     ...
///
/// Fails: as errno says; invalid_argument naming file, line, value and limit.
Result<std::vector<Stroke>> read_stroke_file(const std::filesystem::path& path);

/// The same from text; `name` serves the messages.
Result<std::vector<Stroke>> parse_strokes(std::string_view text, const std::string& name);

}  // namespace burnish
