#pragma once

#include <cstdint>
#include <string>

#include "client/pages/cut_status.h"

namespace burnish {

/// Returns "134 k" or "2.3 M"; small numbers as they are.
std::string counted(uint64_t count);

/// Returns "5.1 MB".
std::string megabytes(uint64_t bytes);

/// Returns the local date, "2026-11-23".
std::string day_of(int64_t unix_seconds);

/// Returns what to say by a picture: "simplified, 40 %", or nothing of one that has full detail, or
/// moves.
std::string text_by_picture(const CutStatus& status);

/// Returns the beginning of the text that fits a width in pixels, with "…" for the rest.
std::string cut_to(const std::string& text, float width);

/// Draws a text within a width. A tooltip shows all of a text that is cut.
void text_with_ellipsis(const std::string& text, float width);

}  // namespace burnish
