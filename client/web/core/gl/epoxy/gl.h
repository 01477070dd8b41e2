#pragma once

#include <cstddef>
#include <cstdint>

// OpenGL as client/gl calls it, in place of libepoxy's header where the core is compiled for
// browsers. Each function is an import of the module "gl"; client/web/engine/gl.ts does it by
// WebGL2.

using GLenum = uint32_t;
using GLbitfield = uint32_t;
using GLuint = uint32_t;
using GLint = int32_t;
using GLsizei = int32_t;
using GLboolean = uint8_t;
using GLubyte = uint8_t;
using GLchar = char;
using GLfloat = float;
using GLsizeiptr = ptrdiff_t;
using GLintptr = ptrdiff_t;
using GLuint64 = uint64_t;
using GLsync = struct GLsyncOfHost*;  // a number of the host's

inline constexpr int GL_ARRAY_BUFFER = 0x8892;
inline constexpr int GL_BLEND = 0xbe2;
inline constexpr int GL_BYTE = 0x1400;
inline constexpr int GL_CLAMP_TO_EDGE = 0x812f;
inline constexpr int GL_COLOR = 0x1800;
inline constexpr int GL_COLOR_ATTACHMENT0 = 0x8ce0;
inline constexpr int GL_COLOR_ATTACHMENT1 = 0x8ce1;
inline constexpr int GL_COLOR_BUFFER_BIT = 0x4000;
inline constexpr int GL_COMPILE_STATUS = 0x8b81;
inline constexpr int GL_COPY_READ_BUFFER = 0x8f36;
inline constexpr int GL_COPY_WRITE_BUFFER = 0x8f37;
inline constexpr int GL_DEPTH_ATTACHMENT = 0x8d00;
inline constexpr int GL_DEPTH_BUFFER_BIT = 0x100;
inline constexpr int GL_DEPTH_COMPONENT = 0x1902;
inline constexpr int GL_DEPTH_COMPONENT24 = 0x81a6;
inline constexpr int GL_DEPTH_TEST = 0xb71;
inline constexpr int GL_DRAW_FRAMEBUFFER = 0x8ca9;
inline constexpr int GL_DYNAMIC_DRAW = 0x88e8;
inline constexpr int GL_ELEMENT_ARRAY_BUFFER = 0x8893;
inline constexpr int GL_FALSE = 0;
inline constexpr int GL_FLOAT = 0x1406;
inline constexpr int GL_FRAGMENT_SHADER = 0x8b30;
inline constexpr int GL_FRAMEBUFFER = 0x8d40;
inline constexpr int GL_FRAMEBUFFER_COMPLETE = 0x8cd5;
inline constexpr int GL_GPU_MEMORY_INFO_CURRENT_AVAILABLE_VIDMEM_NVX = 0x9049;
inline constexpr int GL_HALF_FLOAT = 0x140b;
inline constexpr int GL_INT = 0x1404;
inline constexpr int GL_LINEAR = 0x2601;
inline constexpr int GL_LINEAR_MIPMAP_NEAREST = 0x2701;
inline constexpr int GL_LINES = 1;
inline constexpr int GL_LINK_STATUS = 0x8b82;
inline constexpr int GL_MAX_COLOR_TEXTURE_SAMPLES = 0x910e;
inline constexpr int GL_MAX_DEPTH_TEXTURE_SAMPLES = 0x910f;
inline constexpr int GL_MAX_RENDERBUFFER_SIZE = 0x84e8;
inline constexpr int GL_MAX_SAMPLES = 0x8d57;
inline constexpr int GL_MAX_TEXTURE_SIZE = 0xd33;
inline constexpr int GL_NEAREST = 0x2600;
inline constexpr int GL_NONE = 0;
inline constexpr int GL_NO_ERROR = 0;
inline constexpr int GL_ONE = 1;
inline constexpr int GL_ONE_MINUS_SRC_ALPHA = 0x303;
inline constexpr int GL_OUT_OF_MEMORY = 0x505;
inline constexpr int GL_POLYGON_OFFSET_FILL = 0x8037;
inline constexpr int GL_R8 = 0x8229;
inline constexpr int GL_READ_FRAMEBUFFER = 0x8ca8;
inline constexpr int GL_RED = 0x1903;
inline constexpr int GL_RENDERBUFFER = 0x8d41;
inline constexpr int GL_RENDERER = 0x1f01;
inline constexpr int GL_RGB = 0x1907;
inline constexpr int GL_RGB8 = 0x8051;
inline constexpr int GL_RGBA = 0x1908;
inline constexpr int GL_RGBA16 = 0x805b;
inline constexpr int GL_RGBA16F = 0x881a;
inline constexpr int GL_RGBA8 = 0x8058;
inline constexpr int GL_SCISSOR_TEST = 0xc11;
inline constexpr int GL_SHORT = 0x1402;
inline constexpr int GL_SRC_ALPHA = 0x302;
inline constexpr int GL_SYNC_FLUSH_COMMANDS_BIT = 1;
inline constexpr int GL_SYNC_GPU_COMMANDS_COMPLETE = 0x9117;
inline constexpr int GL_TEXTURE0 = 0x84c0;
inline constexpr int GL_TEXTURE3 = 0x84c3;
inline constexpr int GL_TEXTURE_2D = 0xde1;
inline constexpr int GL_TEXTURE_2D_ARRAY = 0x8c1a;
inline constexpr int GL_TEXTURE_2D_MULTISAMPLE = 0x9100;
inline constexpr int GL_TEXTURE_MAG_FILTER = 0x2800;
inline constexpr int GL_TEXTURE_MAX_LEVEL = 0x813d;
inline constexpr int GL_TEXTURE_MIN_FILTER = 0x2801;
inline constexpr int GL_TEXTURE_WRAP_S = 0x2802;
inline constexpr int GL_TEXTURE_WRAP_T = 0x2803;
inline constexpr int GL_TIMEOUT_EXPIRED = 0x911b;
inline constexpr int GL_TRIANGLES = 4;
inline constexpr int GL_TRUE = 1;
inline constexpr int GL_UNPACK_ALIGNMENT = 0xcf5;
inline constexpr int GL_UNSIGNED_BYTE = 0x1401;
inline constexpr int GL_UNSIGNED_INT = 0x1405;
inline constexpr int GL_VERSION = 0x1f02;
inline constexpr int GL_VERTEX_SHADER = 0x8b31;
inline constexpr int GL_ZERO = 0;

#define BURNISH_GL(name) extern "C" __attribute__((import_module("gl"), import_name(#name)))

BURNISH_GL(glActiveTexture)
void glActiveTexture(GLenum texture);
BURNISH_GL(glAttachShader)
void glAttachShader(GLuint program, GLuint shader);
BURNISH_GL(glBindBuffer)
void glBindBuffer(GLenum target, GLuint buffer);
BURNISH_GL(glBindFramebuffer)
void glBindFramebuffer(GLenum target, GLuint framebuffer);
BURNISH_GL(glBindRenderbuffer)
void glBindRenderbuffer(GLenum target, GLuint renderbuffer);
BURNISH_GL(glBindTexture)
void glBindTexture(GLenum target, GLuint texture);
BURNISH_GL(glBindVertexArray)
void glBindVertexArray(GLuint array);
BURNISH_GL(glBlendFuncSeparate)
void glBlendFuncSeparate(GLenum source, GLenum destination, GLenum source_alpha,
                         GLenum destination_alpha);
BURNISH_GL(glBlitFramebuffer)
void glBlitFramebuffer(GLint from_x0, GLint from_y0, GLint from_x1, GLint from_y1, GLint to_x0,
                       GLint to_y0, GLint to_x1, GLint to_y1, GLbitfield mask, GLenum filter);
BURNISH_GL(glBufferData)
void glBufferData(GLenum target, GLsizeiptr size, const void* data, GLenum usage);
BURNISH_GL(glBufferSubData)
void glBufferSubData(GLenum target, GLintptr offset, GLsizeiptr size, const void* data);
BURNISH_GL(glCheckFramebufferStatus)
GLenum glCheckFramebufferStatus(GLenum target);
BURNISH_GL(glClear)
void glClear(GLbitfield mask);
BURNISH_GL(glClearBufferfv)
void glClearBufferfv(GLenum buffer, GLint draw_buffer, const GLfloat* value);
BURNISH_GL(glClearColor)
void glClearColor(GLfloat red, GLfloat green, GLfloat blue, GLfloat alpha);
BURNISH_GL(glClientWaitSync)
GLenum glClientWaitSync(GLsync sync, GLbitfield flags, GLuint64 timeout_ns);
BURNISH_GL(glColorMask)
void glColorMask(GLboolean red, GLboolean green, GLboolean blue, GLboolean alpha);
BURNISH_GL(glCompileShader)
void glCompileShader(GLuint shader);
BURNISH_GL(glCopyBufferSubData)
void glCopyBufferSubData(GLenum read_target, GLenum write_target, GLintptr read_offset,
                         GLintptr write_offset, GLsizeiptr size);
BURNISH_GL(glCreateProgram)
GLuint glCreateProgram();
BURNISH_GL(glCreateShader)
GLuint glCreateShader(GLenum kind);
BURNISH_GL(glDeleteBuffers)
void glDeleteBuffers(GLsizei count, const GLuint* buffers);
BURNISH_GL(glDeleteFramebuffers)
void glDeleteFramebuffers(GLsizei count, const GLuint* framebuffers);
BURNISH_GL(glDeleteProgram)
void glDeleteProgram(GLuint program);
BURNISH_GL(glDeleteRenderbuffers)
void glDeleteRenderbuffers(GLsizei count, const GLuint* renderbuffers);
BURNISH_GL(glDeleteShader)
void glDeleteShader(GLuint shader);
BURNISH_GL(glDeleteSync)
void glDeleteSync(GLsync sync);
BURNISH_GL(glDeleteTextures)
void glDeleteTextures(GLsizei count, const GLuint* textures);
BURNISH_GL(glDeleteVertexArrays)
void glDeleteVertexArrays(GLsizei count, const GLuint* arrays);
BURNISH_GL(glDisable)
void glDisable(GLenum capability);
BURNISH_GL(glDrawArrays)
void glDrawArrays(GLenum mode, GLint first, GLsizei count);
BURNISH_GL(glDrawElements)
void glDrawElements(GLenum mode, GLsizei count, GLenum type, const void* indices);
BURNISH_GL(glDrawBuffers)
void glDrawBuffers(GLsizei count, const GLenum* buffers);
BURNISH_GL(glEnable)
void glEnable(GLenum capability);
BURNISH_GL(glEnableVertexAttribArray)
void glEnableVertexAttribArray(GLuint index);
BURNISH_GL(glFenceSync)
GLsync glFenceSync(GLenum condition, GLbitfield flags);
BURNISH_GL(glFinish)
void glFinish();
BURNISH_GL(glFramebufferRenderbuffer)
void glFramebufferRenderbuffer(GLenum target, GLenum attachment, GLenum renderbuffer_target,
                               GLuint renderbuffer);
BURNISH_GL(glFramebufferTexture2D)
void glFramebufferTexture2D(GLenum target, GLenum attachment, GLenum texture_target, GLuint texture,
                            GLint level);
BURNISH_GL(glGenBuffers)
void glGenBuffers(GLsizei count, GLuint* buffers);
BURNISH_GL(glGenFramebuffers)
void glGenFramebuffers(GLsizei count, GLuint* framebuffers);
BURNISH_GL(glGenRenderbuffers)
void glGenRenderbuffers(GLsizei count, GLuint* renderbuffers);
BURNISH_GL(glGenTextures)
void glGenTextures(GLsizei count, GLuint* textures);
BURNISH_GL(glGenVertexArrays)
void glGenVertexArrays(GLsizei count, GLuint* arrays);
BURNISH_GL(glGetError)
GLenum glGetError();
BURNISH_GL(glGetIntegerv)
void glGetIntegerv(GLenum name, GLint* value);
BURNISH_GL(glGetProgramInfoLog)
void glGetProgramInfoLog(GLuint program, GLsizei room, GLsizei* length, GLchar* log);
BURNISH_GL(glGetProgramiv)
void glGetProgramiv(GLuint program, GLenum name, GLint* value);
BURNISH_GL(glGetShaderInfoLog)
void glGetShaderInfoLog(GLuint shader, GLsizei room, GLsizei* length, GLchar* log);
BURNISH_GL(glGetShaderiv)
void glGetShaderiv(GLuint shader, GLenum name, GLint* value);
BURNISH_GL(glGetUniformLocation)
GLint glGetUniformLocation(GLuint program, const GLchar* name);
BURNISH_GL(glLinkProgram)
void glLinkProgram(GLuint program);
BURNISH_GL(glMultiDrawElements)
void glMultiDrawElements(GLenum mode, const GLsizei* counts, GLenum type,
                         const void* const* indices, GLsizei draws);
BURNISH_GL(glPixelStorei)
void glPixelStorei(GLenum name, GLint value);
BURNISH_GL(glPolygonOffset)
void glPolygonOffset(GLfloat factor, GLfloat units);
BURNISH_GL(glReadBuffer)
void glReadBuffer(GLenum source);
BURNISH_GL(glReadPixels)
void glReadPixels(GLint x, GLint y, GLsizei width, GLsizei height, GLenum format, GLenum type,
                  void* pixels);
BURNISH_GL(glRenderbufferStorageMultisample)
void glRenderbufferStorageMultisample(GLenum target, GLsizei samples, GLenum format, GLsizei width,
                                      GLsizei height);
BURNISH_GL(glScissor)
void glScissor(GLint x, GLint y, GLsizei width, GLsizei height);
BURNISH_GL(glShaderSource)
void glShaderSource(GLuint shader, GLsizei count, const GLchar* const* sources,
                    const GLint* lengths);
BURNISH_GL(glTexImage2D)
void glTexImage2D(GLenum target, GLint level, GLint internal_format, GLsizei width, GLsizei height,
                  GLint border, GLenum format, GLenum type, const void* pixels);
BURNISH_GL(glTexImage2DMultisample)
void glTexImage2DMultisample(GLenum target, GLsizei samples, GLenum format, GLsizei width,
                             GLsizei height, GLboolean fixed_places);
BURNISH_GL(glTexImage3D)
void glTexImage3D(GLenum target, GLint level, GLint internal_format, GLsizei width, GLsizei height,
                  GLsizei depth, GLint border, GLenum format, GLenum type, const void* pixels);
BURNISH_GL(glTexSubImage3D)
void glTexSubImage3D(GLenum target, GLint level, GLint x, GLint y, GLint z, GLsizei width,
                     GLsizei height, GLsizei depth, GLenum format, GLenum type, const void* pixels);
BURNISH_GL(glTexParameteri)
void glTexParameteri(GLenum target, GLenum name, GLint value);
BURNISH_GL(glUniform1f)
void glUniform1f(GLint location, GLfloat value);
BURNISH_GL(glUniform1i)
void glUniform1i(GLint location, GLint value);
BURNISH_GL(glUniform2fv)
void glUniform2fv(GLint location, GLsizei count, const GLfloat* values);
BURNISH_GL(glUniform2iv)
void glUniform2iv(GLint location, GLsizei count, const GLint* values);
BURNISH_GL(glUniform3fv)
void glUniform3fv(GLint location, GLsizei count, const GLfloat* values);
BURNISH_GL(glUniform4fv)
void glUniform4fv(GLint location, GLsizei count, const GLfloat* values);
BURNISH_GL(glUniformMatrix4fv)
void glUniformMatrix4fv(GLint location, GLsizei count, GLboolean transpose, const GLfloat* values);
BURNISH_GL(glUseProgram)
void glUseProgram(GLuint program);
BURNISH_GL(glVertexAttribIPointer)
void glVertexAttribIPointer(GLuint index, GLint size, GLenum type, GLsizei stride,
                            const void* offset);
BURNISH_GL(glVertexAttribPointer)
void glVertexAttribPointer(GLuint index, GLint size, GLenum type, GLboolean normalized,
                           GLsizei stride, const void* offset);
BURNISH_GL(glViewport)
void glViewport(GLint x, GLint y, GLsizei width, GLsizei height);

/// Returns a text that the host puts into `text`, at most `room` bytes with the end.
BURNISH_GL(glGetText) void glGetText(GLenum name, GLchar* text, GLsizei room);
#undef BURNISH_GL

/// GL_VERSION and GL_RENDERER.
inline const GLubyte* glGetString(GLenum name) {
  static GLchar text[256];
  glGetText(name, text, sizeof(text));
  return reinterpret_cast<const GLubyte*>(text);
}

inline bool epoxy_has_gl_extension(const char*) {
  return false;  // none of those that client/gl asks for
}
