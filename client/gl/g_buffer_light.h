#pragma once

#include <memory>

#include "client/gl/g_buffer_target.h"
#include "client/gl/shader_program.h"
#include "client/scene/camera.h"
#include "client/scene/lighting.h"

namespace burnish {

/// Lights a picture by the pixels around each pixel: radiance scaling, cavity, ambient occlusion.
/// Needs: a current context for its whole life.
class GBufferLight {
 public:
  /// Fails: internal_error when the driver refuses a shader.
  static Result<std::unique_ptr<GBufferLight>> create();
  ~GBufferLight();
  GBufferLight(const GBufferLight&) = delete;
  GBufferLight& operator=(const GBufferLight&) = delete;

  /// Fills the target's ambient occlusion. Needs: surfaces drawn with this camera, in units in
  /// which its distance is given.
  void occlude(const GBufferTarget& target, const Camera& camera) const;

  /// Fills the bound framebuffer with the picture. Needs: as occlude(), and occlude() before if
  /// there is occlusion.
  void draw(const GBufferTarget& target, const Camera& camera, const Lighting& lighting) const;

 private:
  GBufferLight(ShaderProgram occlusion, ShaderProgram g_buffer);
  void fill() const;

  ShaderProgram occlusion_;
  ShaderProgram g_buffer_;
  GLuint vertex_array_ = 0;  // a core profile draws nothing without one
};

}  // namespace burnish
