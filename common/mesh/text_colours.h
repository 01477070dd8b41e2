#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "common/base/types.h"

namespace burnish {

/// Collects the vertex colours of OBJ and OFF. These formats do not say whether colours range to 1
/// or to 255; the largest value of the file decides, once all are read.
class TextColours {
 public:
  /// Sets the colour of vertex number `vertex`; vertices in between are white.
  void set(size_t vertex, const std::array<float, 3>& rgb);

  /// Returns no colours if no vertex had one, else one for each of `vertices`.
  std::vector<Rgba8> finish(size_t vertices);

 private:
  static constexpr float kUnset = -1;
  std::vector<std::array<float, 3>> colours_;
  float largest_ = 0;
};

}  // namespace burnish
