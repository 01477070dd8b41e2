#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

namespace burnish {

/// Disjoint sets of the numbers 0 to count − 1; a set's root is its least number.
class DisjointSets {
 public:
  explicit DisjointSets(size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }

  int32_t root(int32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(int32_t a, int32_t b) {
    if (parent_[a] == parent_[b]) return;  // mostly, once sets are large
    a = root(a);
    b = root(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<int32_t> parent_;
};

}  // namespace burnish
