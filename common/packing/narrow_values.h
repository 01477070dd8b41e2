#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace burnish {

/// A list of integers that never changes. Takes two bytes a value while all fit in them, else four.
class NarrowValues {
 public:
  explicit NarrowValues(std::span<const int32_t> values);

  size_t size() const { return narrow_.size() + wide_.size(); }
  /// Copies the values out. Needs: values.size() is size().
  void read(std::span<int32_t> values) const;
  uint64_t byte_count() const;

 private:
  std::vector<int16_t> narrow_;
  std::vector<int32_t> wide_;  // empty while all values fit in two bytes
};

}  // namespace burnish
