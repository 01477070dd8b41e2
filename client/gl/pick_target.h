#pragma once

#include <cstdint>
#include <optional>

#include <Eigen/Core>
#include <epoxy/gl.h>

#include "client/scene/image.h"
#include "common/base/status.h"

namespace burnish {

/// A target of one pixel that holds a triangle's number plus one, and its depth. Needs: a current
/// context for its whole life.
class PickTarget {
 public:
  PickTarget();
  ~PickTarget();
  PickTarget(const PickTarget&) = delete;
  PickTarget& operator=(const PickTarget&) = delete;

  /// Makes the target empty and ready for drawing. Fails: resource_exhausted.
  Status bind() const;

  /// Returns the triangle drawn last into the pixel, if any.
  std::optional<uint32_t> read() const;

 private:
  GLuint framebuffer_ = 0;
  GLuint number_ = 0;
  GLuint depth_ = 0;
};

/// Returns a matrix that magnifies clip space so that one pixel fills it.
Eigen::Matrix4d pick_matrix(const ImageSize& size, const Eigen::Vector2i& pixel);

}  // namespace burnish
