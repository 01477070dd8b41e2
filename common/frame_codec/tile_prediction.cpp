#include "common/frame_codec/tile_prediction.h"

#include <array>
#include <cstdlib>

#include "common/packing/zigzag.h"

namespace burnish {

namespace {

// The three axes of a value are side by side: their predictions do not wait for each other. The row
// after the last is the zero that predictors may name.
using Rows = std::array<std::array<int32_t, 3>, kTileValues + 1>;

int32_t predict(const Rows& rows, const Predictor& from, int axis) {
  return static_cast<int32_t>(static_cast<uint32_t>(rows[from.a][axis]) +
                              static_cast<uint32_t>(rows[from.b][axis]) -
                              static_cast<uint32_t>(rows[from.c][axis]));
}

int half_step(int step_shift) {
  return (1 << step_shift) >> 1;
}

// Returns the k nearest to the prediction whose step is within the tolerance. It exists: the
// tolerance is at least half a step.
int32_t round_towards(int32_t prediction, int32_t change, int32_t tolerance, int step_shift) {
  const int32_t least = (change - tolerance + (1 << step_shift) - 1) >> step_shift;
  const int32_t greatest = (change + tolerance) >> step_shift;
  return std::clamp(prediction, least, greatest);
}

}  // namespace

bool is_within_slack(const TileRules& rules, std::span<const int32_t> change, int step_shift) {
  const int half = half_step(step_shift), size = rules.size();
  bool within = true;
  for (int axis = 0; axis < 3; ++axis)
    for (int i = 0; i < size; ++i)
      within &= std::abs(change[axis * size + i]) <= half * rules.slack[i];
  return within;
}

void round_and_predict(const TileRules& rules, std::span<const int32_t> change, int step_shift,
                       std::span<int32_t> k, std::span<uint32_t> residuals) {
  const int half = half_step(step_shift), size = rules.size();
  Rows rows;
  rows[kTileValues] = {};
  for (int i = 0; i < size; ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      const int at = axis * size + i;
      const int32_t prediction = predict(rows, rules.predictors[i], axis);
      const int32_t rounded =
          round_towards(prediction, change[at], half * rules.slack[i], step_shift);
      rows[i][axis] = k[at] = rounded;
      residuals[at] = to_zigzag(static_cast<uint32_t>(rounded) - static_cast<uint32_t>(prediction));
    }
  }
}

void undo_prediction(const TileRules& rules, std::span<const uint32_t> residuals,
                     std::span<int32_t> k) {
  const int size = rules.size();
  Rows rows;
  rows[kTileValues] = {};
  for (int i = 0; i < size; ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      const int at = axis * size + i;
      const auto prediction = static_cast<uint32_t>(predict(rows, rules.predictors[i], axis));
      rows[i][axis] = k[at] = static_cast<int32_t>(prediction + from_zigzag(residuals[at]));
    }
  }
}

void apply_change(std::span<const int32_t> k, int step_shift, std::span<int32_t> values) {
  for (size_t i = 0; i < k.size(); ++i)
    values[i] = static_cast<int32_t>(static_cast<uint32_t>(values[i]) +
                                     (static_cast<uint32_t>(k[i]) << step_shift));
}

}  // namespace burnish
