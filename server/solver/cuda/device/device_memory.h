#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "server/solver/cuda/device/stream.h"

namespace burnish::cuda {

/// Takes device memory from the pool. A failure goes to the stream, with the requested and the free
/// bytes.
void* allocate(Stream& stream, uint64_t bytes);
/// Gives memory back to the pool after the device's last use of it.
void release(int device, void* memory, uint64_t bytes);

/// Takes host memory that the device copies to at full speed.
void* allocate_pinned(Stream& stream, uint64_t bytes);
void release_pinned(void* memory);

/// Copies a whole array to the device.
template <typename T>
void upload(Stream& stream, T* device, std::span<const T> host) {
  if (stream.is_ok() && !host.empty())
    stream.check(cudaMemcpyAsync(device, host.data(), host.size_bytes(), cudaMemcpyHostToDevice,
                                 stream.get()),
                 "copying to the device");
}

/// Says how large a matrix is.
struct RowsOf {
  size_t columns = 0;
  size_t rows = 0;
};

/// Copies the rows of a matrix to the device. A row begins `device_pitch` elements after the one
/// before it there, and `host_pitch` elements here.
template <typename T>
void upload_rows(Stream& stream, T* device, size_t device_pitch, const T* host, size_t host_pitch,
                 const RowsOf& of) {
  if (stream.is_ok())
    stream.check(
        cudaMemcpy2DAsync(device, device_pitch * sizeof(T), host, host_pitch * sizeof(T),
                          of.columns * sizeof(T), of.rows, cudaMemcpyHostToDevice, stream.get()),
        "copying to the device");
}

/// Copies an array from the device and waits for it.
template <typename T>
void download(Stream& stream, const T* device, std::span<T> host) {
  if (stream.is_ok() && !host.empty())
    stream.check(cudaMemcpyAsync(host.data(), device, host.size_bytes(), cudaMemcpyDeviceToHost,
                                 stream.get()),
                 "copying from the device");
  stream.synchronize();
}

/// An array on the device, zero at first. It is empty if the stream has failed.
template <typename T>
class DeviceArray {
 public:
  DeviceArray() = default;
  DeviceArray(Stream& stream, size_t count)
      : device_(stream.device()),
        data_(static_cast<T*>(allocate(stream, count * sizeof(T)))),
        size_(data_ ? count : 0) {
    clear(stream);
  }
  DeviceArray(Stream& stream, std::span<const T> host) : DeviceArray(stream, host.size()) {
    upload(stream, host);
  }
  /// Copies an array of another type with the same bytes.
  template <typename Host>
  static DeviceArray copy_of(Stream& stream, std::span<const Host> host) {
    static_assert(sizeof(Host) == sizeof(T));
    return {stream, std::span(reinterpret_cast<const T*>(host.data()), host.size())};
  }
  template <typename Host>
  static DeviceArray copy_of(Stream& stream, const std::vector<Host>& host) {
    return copy_of(stream, std::span<const Host>(host));
  }
  DeviceArray(DeviceArray&& other) noexcept { *this = std::move(other); }
  DeviceArray& operator=(DeviceArray&& other) noexcept {
    std::swap(device_, other.device_);
    std::swap(data_, other.data_);
    std::swap(size_, other.size_);
    return *this;
  }
  ~DeviceArray() { release(device_, data_, byte_count()); }

  T* data() const { return data_; }
  size_t size() const { return size_; }
  uint64_t byte_count() const { return size_ * sizeof(T); }

  void clear(Stream& stream) const {
    if (size_ > 0)
      stream.check(cudaMemsetAsync(data_, 0, byte_count(), stream.get()), "clearing memory");
  }
  void upload(Stream& stream, std::span<const T> host) const { cuda::upload(stream, data_, host); }
  void download(Stream& stream, std::span<T> host) const { cuda::download(stream, data_, host); }

 private:
  int device_ = 0;
  T* data_ = nullptr;
  size_t size_ = 0;
};

/// An array on the host for copies from the device. It is empty if the stream has failed.
template <typename T>
class PinnedArray {
 public:
  PinnedArray() = default;
  PinnedArray(Stream& stream, size_t count)
      : data_(static_cast<T*>(allocate_pinned(stream, count * sizeof(T)))),
        size_(data_ ? count : 0) {}
  PinnedArray(PinnedArray&& other) noexcept { *this = std::move(other); }
  PinnedArray& operator=(PinnedArray&& other) noexcept {
    std::swap(data_, other.data_);
    std::swap(size_, other.size_);
    return *this;
  }
  ~PinnedArray() { release_pinned(data_); }

  T* data() const { return data_; }
  size_t size() const { return size_; }

 private:
  T* data_ = nullptr;
  size_t size_ = 0;
};

}  // namespace burnish::cuda
