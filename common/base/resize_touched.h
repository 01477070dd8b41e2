#pragma once

#include <cstddef>
#include <vector>

namespace burnish {

/// Resizes an empty vector. All threads touch a large one's memory first: the system's handing out
/// of pages takes longer than filling them.
template <typename T>
void resize_touched(std::vector<T>& values, size_t size) {
  values.reserve(size);
#ifdef _OPENMP
  constexpr size_t kPage = 4096, kAlone = 1024;
  auto* const bytes = reinterpret_cast<volatile char*>(values.data());
  const size_t pages = size * sizeof(T) / kPage;
#pragma omp parallel for schedule(static) if (pages > kAlone)
  for (size_t page = 0; page < pages; ++page) bytes[page * kPage] = 0;
#endif
  values.resize(size);
}

}  // namespace burnish
