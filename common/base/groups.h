#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

#include "common/base/resize_touched.h"

namespace burnish {

/// Lists of items, one after the other in one array (compressed rows).
template <typename T, typename Start = int32_t>
struct Groups {
  std::vector<Start> start = {0};  ///< groups + 1, into `item`
  std::vector<T> item;

  size_t count() const { return start.size() - 1; }
  std::span<const T> operator[](size_t group) const {
    return {item.data() + start[group], item.data() + start[group + 1]};
  }
  /// Appends one group.
  void add(std::span<const T> items) {
    item.insert(item.end(), items.begin(), items.end());
    start.push_back(static_cast<Start>(item.size()));
  }
  uint64_t byte_count() const {
    return start.capacity() * sizeof(Start) + item.capacity() * sizeof(T);
  }
};

/// Groups items by a counting sort; a group keeps the order in which its items come.
/// `for_each(add)` calls add(group, item) for every item, and is called twice.
template <typename T, typename Start = int32_t, typename ForEach>
Groups<T, Start> group_by(size_t groups, ForEach&& for_each) {
  Groups<T, Start> made;
  // Counts a group two places further up, so that filling moves each start to its own place.
  made.start.assign(groups + 2, 0);
  for_each([&](size_t group, const T&) { ++made.start[group + 2]; });
  for (size_t i = 2; i < made.start.size(); ++i) made.start[i] += made.start[i - 1];
  made.item.resize(made.start.back());
  for_each([&](size_t group, const T& item) { made.item[made.start[group + 1]++] = item; });
  made.start.pop_back();
  return made;
}

/// Groups the numbers below `count` by group_of(number), which may be negative for none; each group
/// rises. Calls group_of() three times for each number, from several threads. Throws: bad_alloc.
template <typename GroupOf>
Groups<int32_t> group_numbers(size_t groups, int32_t count, const GroupOf& group_of) {
  Groups<int32_t> made;
  made.start.assign(groups + 1, 0);
#pragma omp parallel for schedule(static)
  for (int32_t i = 0; i < count; ++i)
    if (const int32_t group = group_of(i); group >= 0)
      __atomic_add_fetch(&made.start[group + 1], 1, __ATOMIC_RELAXED);
  std::partial_sum(made.start.begin(), made.start.end(), made.start.begin());
  resize_touched(made.item, made.start.back());
  std::vector<int32_t> next(made.start.begin(), made.start.end() - 1);
#pragma omp parallel for schedule(static)
  for (int32_t i = 0; i < count; ++i)
    if (const int32_t group = group_of(i); group >= 0)
      made.item[__atomic_fetch_add(&next[group], 1, __ATOMIC_RELAXED)] = i;
#pragma omp parallel for schedule(static)
  for (size_t group = 0; group < groups; ++group)
    std::sort(made.item.begin() + made.start[group], made.item.begin() + made.start[group + 1]);
  return made;
}

}  // namespace burnish
