#pragma once

#include <algorithm>
#include <vector>

namespace burnish {

/// Sorts the values and keeps each once.
template <typename T>
void sort_once(std::vector<T>& values) {
  std::ranges::sort(values);
  values.erase(std::ranges::unique(values).begin(), values.end());
}

}  // namespace burnish
