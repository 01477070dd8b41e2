#pragma once

#include <memory>

#include "client/gl/relief_target.h"
#include "client/gl/shader_program.h"
#include "client/scene/camera.h"
#include "client/scene/lighting.h"

namespace burnish {

/// Lights a picture by the pixels around each pixel: radiance scaling, cavity, ambient occlusion.
/// Needs: a current context for its whole life.
class ReliefLight {
 public:
  /// Fails: internal_error when the driver refuses a shader.
  static Result<std::unique_ptr<ReliefLight>> create();
  ~ReliefLight();
  ReliefLight(const ReliefLight&) = delete;
  ReliefLight& operator=(const ReliefLight&) = delete;

  /// Fills the target's ambient occlusion. Needs: surfaces drawn with this camera, in units in
  /// which its distance is given.
  void occlude(const ReliefTarget& target, const Camera& camera) const;

  /// Fills the bound framebuffer with the picture. Needs: as occlude(), and occlude() before if
  /// there is occlusion.
  void draw(const ReliefTarget& target, const Camera& camera, const Lighting& lighting) const;

 private:
  ReliefLight(ShaderProgram occlusion, ShaderProgram relief);
  void fill() const;

  ShaderProgram occlusion_;
  ShaderProgram relief_;
  GLuint vertex_array_ = 0;  // a core profile draws nothing without one
};

}  // namespace burnish
