#pragma once

#include <memory>
#include <utility>
#include <vector>

namespace burnish {

/// Leaves new entries uninitialised.
template <typename T>
struct UnsetAllocator : std::allocator<T> {
  template <typename U>
  struct rebind {
    using other = UnsetAllocator<U>;
  };
  template <typename U>
  void construct(U*) {}
  template <typename U, typename... Args>
  void construct(U* at, Args&&... args) {
    std::construct_at(at, std::forward<Args>(args)...);
  }
};

/// A vector whose resize() leaves new entries uninitialised. One thread takes as long to zero a
/// large array as all threads take to fill it.
template <typename T>
using UnsetVector = std::vector<T, UnsetAllocator<T>>;

}  // namespace burnish
