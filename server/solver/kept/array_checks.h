#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "common/base/status.h"

namespace burnish {

/// Returns whether every number is in [low, end).
template <typename T>
bool are_within(const std::vector<T>& numbers, int64_t low, int64_t end) {
  int outside = 0;
#pragma omp parallel for schedule(static) reduction(| : outside)
  for (size_t i = 0; i < numbers.size(); ++i) outside |= numbers[i] < low || numbers[i] >= end;
  return outside == 0;
}

template <typename T, size_t n>
bool are_within(const std::vector<std::array<T, n>>& lists, int64_t low, int64_t end) {
  int outside = 0;
#pragma omp parallel for schedule(static) reduction(| : outside)
  for (size_t i = 0; i < lists.size(); ++i)
    for (const T number : lists[i]) outside |= number < low || number >= end;
  return outside == 0;
}

/// Returns whether is_right(i) holds for 0 to `count`. Calls it from several threads.
template <typename IsRight>
bool all_of_numbers(size_t count, const IsRight& is_right) {
  int wrong = 0;
#pragma omp parallel for schedule(static) reduction(| : wrong)
  for (size_t i = 0; i < count; ++i) wrong |= !is_right(i);
  return wrong == 0;
}

template <typename T>
bool are_rising(const std::vector<T>& values) {
  return all_of_numbers(values.size(),
                        [&](size_t i) { return i == 0 || values[i - 1] < values[i]; });
}

/// Returns whether these are the starts of so many groups that share out so many items.
template <typename Start>
bool are_starts(const std::vector<Start>& start, size_t groups, size_t items) {
  if (start.size() != groups + 1 || start.front() != 0) return false;
  if (static_cast<uint64_t>(start.back()) != items) return false;
  return all_of_numbers(groups, [&](size_t i) { return start[i] <= start[i + 1]; });
}

/// Fails: data_loss.
inline Status check_arrays(bool is_right, int depth, const std::string& what) {
  if (is_right) return Status::ok();
  return data_loss("depth " + std::to_string(depth) + ": " + what + " do not fit each other");
}

}  // namespace burnish
