#include "client/gl/shader_program.h"

#include <array>
#include <utility>

namespace burnish {

static Status compile(GLuint program, GLenum kind, const char* source) {
  const GLuint shader = glCreateShader(kind);
  glShaderSource(shader, 1, &source, nullptr);
  glCompileShader(shader);
  glAttachShader(program, shader);
  glDeleteShader(shader);  // an attached shader stays alive
  GLint compiled = GL_FALSE;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
  if (compiled == GL_TRUE) return Status::ok();
  std::array<char, 1024> log = {};
  glGetShaderInfoLog(shader, log.size(), nullptr, log.data());
  return internal_error(log.data());
}

static Status link(GLuint program) {
  glLinkProgram(program);
  GLint linked = GL_FALSE;
  glGetProgramiv(program, GL_LINK_STATUS, &linked);
  if (linked == GL_TRUE) return Status::ok();
  std::array<char, 1024> log = {};
  glGetProgramInfoLog(program, log.size(), nullptr, log.data());
  return internal_error(log.data());
}

Result<ShaderProgram> ShaderProgram::create(const std::string& name, const char* vertex_source,
                                            const char* fragment_source) {
  ShaderProgram shaders(glCreateProgram());
  const GLuint program = shaders.program_;
  RETURN_IF_ERROR(compile(program, GL_VERTEX_SHADER, vertex_source).with_context(name));
  RETURN_IF_ERROR(compile(program, GL_FRAGMENT_SHADER, fragment_source).with_context(name));
  RETURN_IF_ERROR(link(program).with_context(name));
  return shaders;
}

ShaderProgram::ShaderProgram(ShaderProgram&& other) noexcept
    : program_(std::exchange(other.program_, 0)) {}

ShaderProgram::~ShaderProgram() {
  glDeleteProgram(program_);
}

void ShaderProgram::set(const char* uniform, bool value) const {
  glUniform1i(glGetUniformLocation(program_, uniform), value ? 1 : 0);
}

void ShaderProgram::set(const char* uniform, int value) const {
  glUniform1i(glGetUniformLocation(program_, uniform), value);
}

void ShaderProgram::set(const char* uniform, float value) const {
  glUniform1f(glGetUniformLocation(program_, uniform), value);
}

void ShaderProgram::set(const char* uniform, const Eigen::Vector2i& value) const {
  glUniform2iv(glGetUniformLocation(program_, uniform), 1, value.data());
}

void ShaderProgram::set(const char* uniform, const Eigen::Vector2f& value) const {
  glUniform2fv(glGetUniformLocation(program_, uniform), 1, value.data());
}

void ShaderProgram::set(const char* uniform, const Eigen::Vector3f& value) const {
  glUniform3fv(glGetUniformLocation(program_, uniform), 1, value.data());
}

void ShaderProgram::set(const char* uniform, const Eigen::Vector4f& value) const {
  glUniform4fv(glGetUniformLocation(program_, uniform), 1, value.data());
}

void ShaderProgram::set(const char* uniform, const Eigen::Matrix4f& value) const {
  glUniformMatrix4fv(glGetUniformLocation(program_, uniform), 1, GL_FALSE, value.data());
}

}  // namespace burnish
