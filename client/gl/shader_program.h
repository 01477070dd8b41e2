#pragma once

#include <array>
#include <string>

#include <Eigen/Core>
#include <epoxy/gl.h>

#include "common/base/status.h"

namespace burnish {

/// A linked pair of shaders. Needs: a current context for its whole life.
class ShaderProgram {
 public:
  /// Fails: internal_error with the compiler's log; `name` is only used in the message.
  static Result<ShaderProgram> create(const std::string& name, const char* vertex_source,
                                      const char* fragment_source);
  ShaderProgram(ShaderProgram&& other) noexcept;
  ShaderProgram& operator=(ShaderProgram&&) = delete;
  ~ShaderProgram();

  void use() const { glUseProgram(program_); }
  /// Set uniforms of the program in use.
  void set(const char* uniform, bool value) const;
  void set(const char* uniform, int value) const;
  void set(const char* uniform, float value) const;
  void set(const char* uniform, const Eigen::Vector2i& value) const;
  void set(const char* uniform, const Eigen::Vector2f& value) const;
  void set(const char* uniform, const Eigen::Vector3f& value) const;
  void set(const char* uniform, const Eigen::Vector4f& value) const;
  void set(const char* uniform, const Eigen::Matrix4f& value) const;

  /// For uniforms that are set often: where one is, and how to set it there.
  GLint place(const char* uniform) const { return glGetUniformLocation(program_, uniform); }
  void set(GLint place, const std::array<Eigen::Vector4f, 3>& values) const {
    glUniform4fv(place, 3, values[0].data());
  }

 private:
  explicit ShaderProgram(GLuint program) : program_(program) {}

  GLuint program_;  // 0 when moved from
};

}  // namespace burnish
