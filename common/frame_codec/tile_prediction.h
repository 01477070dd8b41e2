#pragma once

#include <cstdint>
#include <span>

#include "common/frame_codec/frame_layout.h"

namespace burnish {

/// Predictors and bounds of the values of one tile: spans into the layout, one entry per value.
struct TileRules {
  std::span<const Predictor> predictors;
  std::span<const uint16_t> slack;

  int size() const { return static_cast<int>(predictors.size()); }
};

inline TileRules rules_of(const FrameLayout& layout, int tile) {
  const size_t begin = layout.tile_begin(tile), size = layout.tile_size(tile);
  return {std::span(layout.predictors).subspan(begin, size),
          std::span(layout.slack).subspan(begin, size)};
}

// Shapes below: all x of the tile, then all y, then all z.

/// Returns true if a tile need not be sent: each wanted change is within slack × half a step of
/// zero. With step_shift 0 half a step is 0, so each wanted change must be zero.
bool is_within_slack(const TileRules& rules, std::span<const int32_t> change, int step_shift);

/// Rounds a wanted change to steps k of 2^step_shift, each as near to its prediction as the slack
/// allows, and gives the zigzag residuals against the predictions.
/// Needs: |change| <= 2^30.
void round_and_predict(const TileRules& rules, std::span<const int32_t> change, int step_shift,
                       std::span<int32_t> k, std::span<uint32_t> residuals);

/// Returns the k of any residuals; the inverse of round_and_predict().
void undo_prediction(const TileRules& rules, std::span<const uint32_t> residuals,
                     std::span<int32_t> k);

/// Adds k << step_shift to the values, modulo 2^32.
void apply_change(std::span<const int32_t> k, int step_shift, std::span<int32_t> values);

}  // namespace burnish
