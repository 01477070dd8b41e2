#pragma once

#include <algorithm>
#include <mutex>
#include <utility>
#include <vector>

namespace burnish::cpu {

/// An array for the temporary numbers of a new matrix; its entries are uninitialised. Touching
/// fresh pages costs more than the writes, so three arrays of each type stay allocated and serve
/// all sessions.
template <typename T>
class Scratch {
 public:
  explicit Scratch(size_t count) : buffer_(take()) {
    if (buffer_.size() < count) buffer_.resize(count);
  }
  ~Scratch() { give_back(std::move(buffer_)); }
  Scratch(Scratch&& other) noexcept : buffer_(std::move(other.buffer_)) {}
  Scratch& operator=(Scratch&& other) noexcept {
    buffer_.swap(other.buffer_);
    return *this;
  }

  T& operator[](size_t i) { return buffer_[i]; }
  const T& operator[](size_t i) const { return buffer_[i]; }

 private:
  static constexpr size_t kKept = 3;
  struct Kept {
    std::mutex mutex;
    std::vector<std::vector<T>> buffers;  // by rising size
  };
  static Kept& kept() {
    static Kept one;
    return one;
  }
  static std::vector<T> take() {
    const std::lock_guard lock(kept().mutex);
    if (kept().buffers.empty()) return {};
    std::vector<T> largest = std::move(kept().buffers.back());
    kept().buffers.pop_back();
    return largest;
  }
  static void give_back(std::vector<T> buffer) {
    if (buffer.empty()) return;
    const std::lock_guard lock(kept().mutex);
    auto& buffers = kept().buffers;
    const auto smaller = [](const auto& a, const auto& b) { return a.size() < b.size(); };
    buffers.insert(std::upper_bound(buffers.begin(), buffers.end(), buffer, smaller),
                   std::move(buffer));
    if (buffers.size() > kKept) buffers.erase(buffers.begin());
  }

  std::vector<T> buffer_;
};

}  // namespace burnish::cpu
