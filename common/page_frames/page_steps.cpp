#include "common/page_frames/page_steps.h"

#include <array>
#include <cstddef>
#include <vector>

#include "common/packing/zigzag.h"

namespace burnish {

namespace {

/// The steps k of one page, with the three axes of a value side by side: their predictions do not
/// wait for each other.
class PageChanges {
 public:
  explicit PageChanges(const PageLayout& layout) : layout_(layout), rows_(layout.value_count()) {}

  std::array<int32_t, 3>& operator[](size_t value) { return rows_[value]; }

  /// Returns the mean of the predictors, halves up. Needs: their rows.
  std::array<int32_t, 3> predict(size_t value) const {
    const auto predictors = layout_.predictors[value];
    const auto count = static_cast<int64_t>(predictors.size());
    if (count == 0) return {};
    if (count == 1) return rows_[predictors[0]];
    std::array<int64_t, 3> sum = {};
    for (const uint16_t from : predictors)
      for (int axis = 0; axis < 3; ++axis) sum[axis] += rows_[from][axis];
    std::array<int32_t, 3> mean;
    for (int axis = 0; axis < 3; ++axis)
      mean[axis] = static_cast<int32_t>(floor_of(2 * sum[axis] + count, 2 * count));
    return mean;
  }

 private:
  static int64_t floor_of(int64_t dividend, int64_t divisor) {
    const int64_t quotient = dividend / divisor;
    return quotient * divisor > dividend ? quotient - 1 : quotient;
  }

  const PageLayout& layout_;
  std::vector<std::array<int32_t, 3>> rows_;
};

uint32_t difference(int32_t a, int32_t b) {
  return static_cast<uint32_t>(a) - static_cast<uint32_t>(b);
}

int32_t sum(int32_t a, uint32_t b) {
  return static_cast<int32_t>(static_cast<uint32_t>(a) + b);
}

}  // namespace

bool code_page(const PageLayout& layout, std::span<const int32_t> wanted, int shift,
               std::span<int32_t> values, std::span<uint32_t> residuals) {
  const size_t size = layout.value_count();
  PageChanges changes(layout);
  uint32_t changed = 0;
  for (size_t i = 0; i < size; ++i) {
    const std::array<int32_t, 3> prediction = changes.predict(i);
    for (int axis = 0; axis < 3; ++axis) {
      const size_t at = axis * size + i;
      const int32_t steps = round_to_step(wanted[at], shift);
      const uint32_t k = difference(steps, round_to_step(values[at], shift));
      changes[i][axis] = static_cast<int32_t>(k);
      residuals[at] = to_zigzag(difference(static_cast<int32_t>(k), prediction[axis]));
      const int32_t fresh = value_of_step(steps, shift);
      changed |= static_cast<uint32_t>(fresh ^ values[at]);
      values[at] = fresh;
    }
  }
  return changed != 0;
}

void undo_page(const PageLayout& layout, std::span<const uint32_t> residuals, int shift,
               std::span<int32_t> values) {
  const size_t size = layout.value_count();
  PageChanges changes(layout);
  for (size_t i = 0; i < size; ++i) {
    const std::array<int32_t, 3> prediction = changes.predict(i);
    for (int axis = 0; axis < 3; ++axis) {
      const size_t at = axis * size + i;
      const int32_t k = sum(prediction[axis], from_zigzag(residuals[at]));
      changes[i][axis] = k;
      const int32_t old = round_to_step(values[at], shift);
      values[at] = value_of_step(sum(old, static_cast<uint32_t>(k)), shift);
    }
  }
}

}  // namespace burnish
