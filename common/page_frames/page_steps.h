#pragma once

#include <cstdint>
#include <span>

#include "common/page_frames/page_layout.h"

namespace burnish {

/// Rounds a value in steps of 1/256 cell to whole steps of 2^shift such steps; halves go up.
constexpr int32_t round_to_step(int32_t value, int shift) {
  const uint32_t half = (1u << shift) >> 1;
  return static_cast<int32_t>(static_cast<uint32_t>(value) + half) >> shift;
}

/// Returns the value of a whole number of steps, modulo 2^32.
constexpr int32_t value_of_step(int32_t steps, int shift) {
  return static_cast<int32_t>(static_cast<uint32_t>(steps) << shift);
}

// Shapes below: all x of a page, then all y, then all z.

/// Codes wanted values against old ones, and rounds `values`, which are the old ones at first, to
/// the new ones. Returns whether any value has changed. The formula is in page_frame_header.h.
bool code_page(const PageLayout& layout, std::span<const int32_t> wanted, int shift,
               std::span<int32_t> values, std::span<uint32_t> residuals);

/// Turns the old values into the new ones. Takes any residuals.
void undo_page(const PageLayout& layout, std::span<const uint32_t> residuals, int shift,
               std::span<int32_t> values);

}  // namespace burnish
