#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

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

}  // namespace burnish
