#pragma once

#include <algorithm>
#include <functional>

namespace burnish {

/// Sorts as std::ranges::sort() does, in a fifth of its code, which browsers load: for lists of
/// some thousand elements. Cost: O(n log n), about twice the time.
template <typename List, typename Less = std::ranges::less, typename Key = std::identity>
void heap_sort(List& list, Less less = {}, Key key = {}) {
  std::ranges::make_heap(list, less, key);
  std::ranges::sort_heap(list, less, key);
}

}  // namespace burnish
