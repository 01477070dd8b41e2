#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "common/edit/brush.h"

namespace burnish {

/// Reads strokes from text: each has a line for its brush, then lines for the points of its path.
/// Lengths are in the scan's units; FALLOFF is smooth, linear, sharp or constant; '#' begins a
/// comment. WHAT is what the brush paints: beta, or band:NUMBER for the gain of a band, which then
/// stands in BETA's place, or curve:NUMBER for a curve of the palette. With "through" the brush
/// paints through walls.
///
///     brush RADIUS STRENGTH BETA FALLOFF [WHAT] [through]
///     X Y Z
///     ...
///
/// Fails: as errno says; invalid_argument that names file, line, value and limit.
Result<std::vector<Stroke>> read_stroke_file(const std::filesystem::path& path);

/// Parses the same text from memory; `name` is used in messages.
Result<std::vector<Stroke>> parse_strokes(std::string_view text, const std::string& name);

}  // namespace burnish
