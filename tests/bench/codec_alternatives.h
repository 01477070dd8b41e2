#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "common/frame_codec/frame_layout.h"
#include "common/frame_codec/frame_sample.h"
#include "common/frame_codec/frame_state.h"

namespace burnish {

/// The cost of the same frame in another encoding.
struct AlternativeCost {
  std::string name;
  size_t bytes = 0;
  double milliseconds = 0;  ///< to encode, on one core
};

/// Encodes the rounded change from `held`, the state after the product's own frames, to `sample`.
/// It has no prediction and no slack, and only tiles where the change is not zero. The encodings:
/// int16 through zstd; byte planes of differences along the tile through zstd; meshoptimizer's
/// vertex codec (8 bytes a value), then zstd. All at level 1. Changes beyond int16 are cut off: a
/// real encoding would also need an escape.
std::vector<AlternativeCost> alternative_costs(const FrameLayout& layout, const FrameState& held,
                                               const FrameSample& sample, int step_shift);

}  // namespace burnish
