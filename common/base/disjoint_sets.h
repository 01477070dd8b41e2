#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "common/base/resize_touched.h"

namespace burnish {

/// Disjoint sets of the numbers 0 to count − 1, in an array of somebody else. A set's root is its
/// least number, in whatever order sets are joined. Threads may join and ask at once: a number's
/// parent only ever falls. A root is certain once nobody joins.
class DisjointSetsIn {
 public:
  explicit DisjointSetsIn(std::span<int32_t> parent) : parent_(parent) {
#pragma omp parallel for schedule(static)
    for (size_t i = 0; i < parent_.size(); ++i) parent_[i] = static_cast<int32_t>(i);
  }

  int32_t root(int32_t i) {
    for (int32_t parent = parent_of(i); parent != i;) {
      const int32_t above = parent_of(parent);
      if (above == parent) return parent;
      __atomic_store_n(&parent_[i], above, __ATOMIC_RELAXED);
      i = above;
      parent = parent_of(i);
    }
    return i;
  }
  void join(int32_t a, int32_t b) {
    if (parent_of(a) == parent_of(b)) return;  // mostly, once sets are large
    do {
      a = root(a);
      b = root(b);
    } while (a != b && !hang(std::max(a, b), std::min(a, b)));
  }

 private:
  int32_t parent_of(int32_t i) const {
    return __atomic_load_n(&parent_[i], __ATOMIC_RELAXED);
  }
  // Returns false if another thread was faster.
  bool hang(int32_t root, int32_t on) {
    return __atomic_compare_exchange_n(&parent_[root], &root, on, false, __ATOMIC_RELAXED,
                                       __ATOMIC_RELAXED);
  }

  std::span<int32_t> parent_;
};

/// The same in an array of its own.
class DisjointSets {
 public:
  explicit DisjointSets(size_t count) : parent_(touched(count)), sets_(parent_) {}
  DisjointSets(DisjointSets&&) = default;
  DisjointSets(const DisjointSets&) = delete;

  int32_t root(int32_t i) { return sets_.root(i); }
  void join(int32_t a, int32_t b) { sets_.join(a, b); }

 private:
  static std::vector<int32_t> touched(size_t count) {
    std::vector<int32_t> parent;
    resize_touched(parent, count);
    return parent;
  }

  std::vector<int32_t> parent_;
  DisjointSetsIn sets_;
};

}  // namespace burnish
