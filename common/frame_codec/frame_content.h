#pragma once

#include <cstdint>

namespace burnish {

/// What the values of a frame are.
enum class FrameContent : uint8_t {
  kCoefficients,  ///< the displacement at corners that weigh on a vertex
  kVertices,      ///< the displacement of vertices that lie in a cell
};

}  // namespace burnish
