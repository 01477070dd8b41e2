#pragma once

#include <algorithm>
#include <cstddef>

#include "common/base/heard_loop.h"

namespace burnish {

inline constexpr size_t kLargeGroup = 1 << 14;  // sorting it takes about a millisecond

/// Calls visit(group, sort) for 0 to `count` by all threads; sort(range, less) sorts. A large group
/// is visited by the calling thread, because it alone hears a cancel: a file may have all that it
/// has in one group. `size_of(group)`: how much there is to sort. A visit throws nothing.
template <typename SizeOf, typename Visit>
void for_each_group_heard(const LoopPart& part, size_t count, const SizeOf& size_of,
                          const Visit& visit) {
  parallel_for_heard(part.of(0, 0.9), count, [&](size_t group) {
    const auto sort = [](auto&& range, const auto& less) {
      std::sort(range.begin(), range.end(), less);
    };
    if (size_of(group) <= kLargeGroup) visit(group, sort);
  });
  const auto sort = [rest = part.of(0.9, 1)](auto&& range, const auto& less) {
    sort_heard(rest, range.begin(), range.end(), less);
  };
  for (size_t group = 0; group < count; ++group)
    if (size_of(group) > kLargeGroup) visit(group, sort);
}

}  // namespace burnish
