#pragma once

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <type_traits>
#include <utility>

#include "common/base/scratch_space.h"

namespace burnish {

/// An array in scratch space. Movable. Its entries begin as zero bytes.
template <typename T>
class ScratchArray {
  static_assert(std::is_trivially_destructible_v<T>, "the bytes go without a destructor");

 public:
  ScratchArray() = default;
  ScratchArray(const ScratchSpace& space, size_t size)
      : block_(space.allocate(size * sizeof(T))), size_(size) {}
  ScratchArray(ScratchArray&& other) noexcept
      : block_(std::move(other.block_)), size_(std::exchange(other.size_, 0)) {}
  ScratchArray& operator=(ScratchArray&& other) noexcept {
    block_ = std::move(other.block_);
    std::swap(size_, other.size_);
    return *this;
  }

  size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  T* data() { return static_cast<T*>(block_.data()); }
  const T* data() const { return static_cast<const T*>(block_.data()); }
  T* begin() { return data(); }
  T* end() { return data() + size_; }
  const T* begin() const { return data(); }
  const T* end() const { return data() + size_; }
  T& operator[](size_t i) { return data()[i]; }
  const T& operator[](size_t i) const { return data()[i]; }
  T& back() { return data()[size_ - 1]; }
  const T& back() const { return data()[size_ - 1]; }

  /// Leaves out the last entries. Needs: size <= size().
  void truncate(size_t size) { size_ = size; }

 private:
  ScratchBlock block_;
  size_t size_ = 0;
};

/// Returns a copy in scratch space.
template <typename Range>
auto copy_to(const ScratchSpace& space, const Range& from) {
  using T = std::remove_cvref_t<decltype(*from.data())>;
  ScratchArray<T> copy(space, from.size());
  std::copy_n(from.data(), from.size(), copy.data());
  return copy;
}

}  // namespace burnish
