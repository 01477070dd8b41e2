#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

namespace burnish {

/// Disjoint sets of the numbers 0 to count − 1, in an array of somebody else. A set's root is its
/// least number.
class DisjointSetsIn {
 public:
  explicit DisjointSetsIn(std::span<int32_t> parent) : parent_(parent) {
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
  std::span<int32_t> parent_;
};

/// The same in an array of its own.
class DisjointSets {
 public:
  explicit DisjointSets(size_t count) : parent_(count), sets_(parent_) {}
  DisjointSets(DisjointSets&&) = default;
  DisjointSets(const DisjointSets&) = delete;

  int32_t root(int32_t i) { return sets_.root(i); }
  void join(int32_t a, int32_t b) { sets_.join(a, b); }

 private:
  std::vector<int32_t> parent_;
  DisjointSetsIn sets_;
};

}  // namespace burnish
