#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "server/solver/cuda/device/device_memory.h"
#include "server/solver/cuda/device/named_bits.h"

namespace burnish::cuda {

/// Appends an array of the device, and waits for it. Appends nothing for a null one.
template <typename T>
void read_bits(Stream& stream, std::string name, const T* device, size_t count,
               std::vector<NamedBits>& to) {
  static_assert(sizeof(T) % sizeof(uint32_t) == 0);
  if (device == nullptr) return;
  NamedBits& read = to.emplace_back();
  read.name = std::move(name);
  read.bits.resize(count * (sizeof(T) / sizeof(uint32_t)));
  download(stream, reinterpret_cast<const uint32_t*>(device), std::span(read.bits));
}
template <typename T>
void read_bits(Stream& stream, std::string name, const DeviceArray<T>& array,
               std::vector<NamedBits>& to) {
  read_bits(stream, std::move(name), array.data(), array.size(), to);
}

}  // namespace burnish::cuda
