#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace burnish::cuda {

/// An array of a device by its name, as words of 32 bits.
struct NamedBits {
  std::string name;
  std::vector<uint32_t> bits;
};

}  // namespace burnish::cuda
