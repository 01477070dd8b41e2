#pragma once

#include <memory>

#include "client/gl/shader_program.h"

namespace burnish {

/// Draws what lies behind the surface. Needs: a current context for its whole life.
class Background {
 public:
  /// Fails: internal_error when the driver refuses a shader.
  static Result<std::unique_ptr<Background>> create();
  ~Background();
  Background(const Background&) = delete;
  Background& operator=(const Background&) = delete;

  /// Fills the current target.
  void draw() const;

 private:
  explicit Background(ShaderProgram program);

  ShaderProgram program_;
  GLuint vertex_array_ = 0;  // a core profile draws nothing without one
};

}  // namespace burnish
