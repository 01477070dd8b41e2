#pragma once

#include <memory>

#include <epoxy/gl.h>

#include "client/gl/g_buffer_samples.h"
#include "client/scene/image.h"
#include "common/base/status.h"

namespace burnish {

/// The G-buffer: textures that a picture is drawn into when its light needs the pixels around each
/// pixel. They are multisampled, or in OpenGL ES the averages of samples. colours: sRGB.
/// geometries: the normal in camera space, folded to a square; strength of the light; part of the
/// surface in the colour. Needs: a current context for its whole life.
class GBufferTarget {
 public:
  GBufferTarget();
  ~GBufferTarget();
  GBufferTarget(const GBufferTarget&) = delete;
  GBufferTarget& operator=(const GBufferTarget&) = delete;

  /// Makes the target ready for the background, which has no geometry. Needs: a valid size.
  /// Fails: resource_exhausted (the driver's limit or memory).
  Status bind_for_background(const ImageSize& size);
  /// Makes the target ready for surfaces.
  void bind_for_surfaces() const;
  /// Ends the drawing of surfaces. The textures hold them from here on.
  void resolve() const;
  /// Makes the target of ambient occlusion ready, one value per pixel.
  void bind_for_occlusion() const;

  /// Bind the textures to units 0 (colours), 1 (geometries), 2 (depths) and 3 (occlusions).
  void bind_textures() const;

  const ImageSize& size() const { return size_; }
  int samples() const { return samples_; }

 private:
  Status allocate(const ImageSize& size);
  void attach_all_samples(const ImageSize& size);
  void attach_averages(const ImageSize& size) const;

  ImageSize size_;
  GLint samples_ = 1;                      // of a texture
  std::unique_ptr<GBufferSamples> drawn_;  // null where textures have samples
  GLuint surfaces_ = 0;                    // framebuffers
  GLuint occluded_ = 0;
  GLuint colours_ = 0;  // textures
  GLuint geometries_ = 0;
  GLuint depths_ = 0;
  GLuint occlusions_ = 0;
};

}  // namespace burnish
