#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "common/mesh/triangle_mesh.h"

namespace burnish {

/// The vertex colours of OBJ and OFF, which say nowhere whether they count to 1 or to 255: the
/// file's largest value tells, once all are seen.
class TextColours {
 public:
  /// The colour of vertex number `vertex`; vertices in between are white.
  void set(size_t vertex, const std::array<float, 3>& rgb);

  /// None if no vertex had one, else one for each of `vertices`.
  std::vector<Rgba8> finish(size_t vertices);

 private:
  static constexpr float kUnset = -1;
  std::vector<std::array<float, 3>> colours_;
  float largest_ = 0;
};

}  // namespace burnish
