#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "common/frame_codec/frame_layout.h"
#include "common/frame_codec/frame_sample.h"
#include "common/frame_codec/frame_state.h"

namespace burnish {

/// What another way to write the same frame would have cost.
struct AlternativeCost {
  std::string name;
  size_t bytes = 0;
  double milliseconds = 0;  ///< to encode, on one core
};

/// The rounded change from `held`, what our own frames left, to `sample`, without prediction and
/// without slack, in the tiles where it is not zero, as: int16 through zstd; byte planes of
/// differences along the tile through zstd; meshoptimizer's vertex codec (8 bytes a value), then
/// zstd. All at level 1. Changes beyond int16 are cut off: the alternatives would need an escape
/// besides.
std::vector<AlternativeCost> alternative_costs(const FrameLayout& layout, const FrameState& held,
                                               const FrameSample& sample, int step_shift);

}  // namespace burnish
