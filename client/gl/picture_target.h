#pragma once

#include <Eigen/Core>
#include <epoxy/gl.h>

#include "client/scene/image.h"
#include "common/base/status.h"

namespace burnish {

/// The target of a picture: a multisampled colour and depth buffer, and a plain colour buffer for
/// the averaged samples. Needs: a current context for its whole life.
class PictureTarget {
 public:
  PictureTarget();
  ~PictureTarget();
  PictureTarget(const PictureTarget&) = delete;
  PictureTarget& operator=(const PictureTarget&) = delete;

  /// Makes the target ready for drawing at this size.
  /// Fails: invalid_argument (check_image_size), resource_exhausted (the driver's limit or memory).
  Status bind(const ImageSize& size);

  /// Makes the plain buffer ready for drawing, instead of the samples. Needs: bind() before.
  void bind_resolved() const;

  /// Averages the samples into the plain buffer.
  void resolve() const;

  /// Copies the resolved picture into the window's own buffer.
  void show(const Eigen::Vector2i& lower_left) const;

  /// Returns the resolved picture. Fails: failed_precondition before the first bind().
  Result<Image> read() const;

 private:
  Status allocate(const ImageSize& size);

  ImageSize size_;
  GLuint samples_ = 0;
  GLuint samples_colour_ = 0;
  GLuint samples_depth_ = 0;
  GLuint resolved_ = 0;
  GLuint resolved_colour_ = 0;
};

}  // namespace burnish
