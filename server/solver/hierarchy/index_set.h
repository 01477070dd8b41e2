#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace burnish {

/// A set of indices. Inserting takes the same time whatever the size.
class IndexSet {
 public:
  /// `bound`: more than the largest index.
  explicit IndexSet(size_t bound) : has_(bound, 0) {}

  void insert(int32_t index) {
    if (std::exchange(has_[index], uint8_t{1}) == 0) indices_.push_back(index);
  }
  bool contains(int32_t index) const { return has_[index] != 0; }

  /// Returns the indices, rising, and leaves the set useless.
  std::vector<int32_t> take_rising() {
    std::ranges::sort(indices_);
    return std::move(indices_);
  }

 private:
  std::vector<uint8_t> has_;
  std::vector<int32_t> indices_;
};

}  // namespace burnish
