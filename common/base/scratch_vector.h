#pragma once

#include <algorithm>
#include <span>

#include "common/base/scratch_array.h"

namespace burnish {

/// An array in scratch space that grows at its end.
template <typename T>
class ScratchVector {
 public:
  explicit ScratchVector(const ScratchSpace& space) : space_(space) {}

  size_t size() const { return size_; }
  T* data() { return array_.data(); }
  const T* data() const { return array_.data(); }
  T& operator[](size_t i) { return array_[i]; }
  const T& operator[](size_t i) const { return array_[i]; }

  void reserve(size_t capacity) {
    if (capacity <= array_.size()) return;
    ScratchArray<T> larger(space_, capacity);
    std::copy_n(array_.begin(), size_, larger.begin());
    array_ = std::move(larger);
  }
  void resize(size_t size, const T& value) {
    reserve(size);
    if (size > size_) std::fill(array_.begin() + size_, array_.begin() + size, value);
    size_ = size;
  }
  /// Appends a row of values.
  void append(std::span<const T> values) {
    if (size_ + values.size() > array_.size())
      reserve(std::max(size_ + values.size(), size_ + size_ / 2));
    std::copy(values.begin(), values.end(), array_.begin() + size_);
    size_ += values.size();
  }
  void push_back(const T& value) {
    if (size_ == array_.size()) reserve(std::max<size_t>(1024, size_ + size_ / 2));
    array_[size_++] = value;
  }

  /// Returns the entries and leaves none.
  ScratchArray<T> take() {
    array_.truncate(size_);
    size_ = 0;
    return std::move(array_);
  }

 private:
  ScratchSpace space_;
  ScratchArray<T> array_;
  size_t size_ = 0;
};

}  // namespace burnish
