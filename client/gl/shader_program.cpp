#include "client/gl/shader_program.h"

#include <array>
#include <utility>

#include "client/gl/dialect.h"

namespace burnish {

// One source serves both languages. A surface's texture holds samples, or in ES their averages, and
// then alpha says how many of them the surface has.
static const char* preamble() {
  if (!is_embedded())
    return "#version 330 core\n#define SurfaceSampler sampler2DMS\n#define covered_part(colour) "
           "1.0\n";
  return "#version 300 es\n"
         "precision highp float;\nprecision highp int;\nprecision highp sampler2D;\n"
         "precision highp sampler2DArray;\n"
         "#define SurfaceSampler sampler2D\n#define covered_part(colour) (colour).a\n";
}

static Status compile(GLuint program, GLenum kind, const char* source) {
  const GLuint shader = glCreateShader(kind);
  const std::array<const char*, 2> sources = {preamble(), source};
  glShaderSource(shader, sources.size(), sources.data(), nullptr);
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
