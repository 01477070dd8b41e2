#include "client/gl/g_buffer_target.h"

#include <algorithm>
#include <array>

#include "client/gl/dialect.h"
#include "client/gl/gl_error.h"
#include "client/gl/target_limits.h"

namespace burnish {

static GLint samples_of_textures() {
  return std::min({kSamplesWanted, integer_limit(GL_MAX_COLOR_TEXTURE_SAMPLES),
                   integer_limit(GL_MAX_DEPTH_TEXTURE_SAMPLES)});
}

static void attach_samples(GLenum attachment, GLuint texture, GLint samples, GLenum format,
                           const ImageSize& size) {
  glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, texture);
  glTexImage2DMultisample(GL_TEXTURE_2D_MULTISAMPLE, samples, format, size.width, size.height,
                          GL_TRUE);
  glFramebufferTexture2D(GL_FRAMEBUFFER, attachment, GL_TEXTURE_2D_MULTISAMPLE, texture, 0);
}

// The formats of a texture, as OpenGL takes them.
struct TextureFormat {
  GLint stored;
  GLenum parts;
  GLenum type;
};

static void attach_values(GLenum attachment, GLuint texture, const TextureFormat& format,
                          const ImageSize& size) {
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexImage2D(GL_TEXTURE_2D, 0, format.stored, size.width, size.height, 0, format.parts,
               format.type, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glFramebufferTexture2D(GL_FRAMEBUFFER, attachment, GL_TEXTURE_2D, texture, 0);
}

GBufferTarget::GBufferTarget() {
  glGenFramebuffers(1, &surfaces_);
  glGenFramebuffers(1, &occluded_);
  for (GLuint* texture : {&colours_, &geometries_, &depths_, &occlusions_})
    glGenTextures(1, texture);
  if (is_embedded()) drawn_ = std::make_unique<GBufferSamples>();
}

GBufferTarget::~GBufferTarget() {
  for (const GLuint* texture : {&colours_, &geometries_, &depths_, &occlusions_})
    glDeleteTextures(1, texture);
  glDeleteFramebuffers(1, &occluded_);
  glDeleteFramebuffers(1, &surfaces_);
}

void GBufferTarget::attach_all_samples(const ImageSize& size) {
  samples_ = samples_of_textures();
  attach_samples(GL_COLOR_ATTACHMENT0, colours_, samples_, GL_RGBA8, size);
  attach_samples(GL_COLOR_ATTACHMENT1, geometries_, samples_, GL_RGBA16, size);
  attach_samples(GL_DEPTH_ATTACHMENT, depths_, samples_, GL_DEPTH_COMPONENT24, size);
}

void GBufferTarget::attach_averages(const ImageSize& size) const {
  attach_values(GL_COLOR_ATTACHMENT0, colours_, {GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE}, size);
  attach_values(GL_COLOR_ATTACHMENT1, geometries_, {GL_RGBA16F, GL_RGBA, GL_HALF_FLOAT}, size);
  attach_values(GL_DEPTH_ATTACHMENT, depths_,
                {GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT}, size);
}

Status GBufferTarget::allocate(const ImageSize& size) {
  const std::string what = picture_name(size);
  RETURN_IF_ERROR(check_side(size, GL_MAX_TEXTURE_SIZE));
  glBindFramebuffer(GL_FRAMEBUFFER, occluded_);
  attach_values(GL_COLOR_ATTACHMENT0, occlusions_, {GL_R8, GL_RED, GL_UNSIGNED_BYTE}, size);
  glBindFramebuffer(GL_FRAMEBUFFER, surfaces_);
  if (drawn_) {
    attach_averages(size);
  } else {
    attach_all_samples(size);
  }
  bool is_complete = glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
  if (drawn_) is_complete = drawn_->allocate(size) && is_complete;
  RETURN_IF_ERROR(check_gl(what));
  if (!is_complete)
    return resource_exhausted(what + ": the graphics driver offers no buffers for its light");
  size_ = size;
  return Status::ok();
}

Status GBufferTarget::bind_for_background(const ImageSize& size) {
  if (size != size_) RETURN_IF_ERROR(allocate(size));
  if (drawn_) {
    drawn_->bind();
  } else {
    glBindFramebuffer(GL_FRAMEBUFFER, surfaces_);
  }
  glViewport(0, 0, size.width, size.height);
  static constexpr GLenum kColours = GL_COLOR_ATTACHMENT0;
  glDrawBuffers(1, &kColours);
  return Status::ok();
}

void GBufferTarget::bind_for_surfaces() const {
  static constexpr std::array<GLenum, 2> kBoth = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
  static constexpr std::array<GLfloat, 4> kNothing = {};
  if (drawn_) drawn_->clear_cover();
  glDrawBuffers(kBoth.size(), kBoth.data());
  glClearBufferfv(GL_COLOR, 1, kNothing.data());
}

void GBufferTarget::resolve() const {
  if (drawn_) drawn_->resolve(size_, surfaces_);
}

void GBufferTarget::bind_for_occlusion() const {
  glBindFramebuffer(GL_FRAMEBUFFER, occluded_);
}

void GBufferTarget::bind_textures() const {
  const std::array<GLuint, 3> sampled = {colours_, geometries_, depths_};
  for (GLuint unit = 0; unit < sampled.size(); ++unit) {
    glActiveTexture(GL_TEXTURE0 + unit);
    glBindTexture(drawn_ ? GL_TEXTURE_2D : GL_TEXTURE_2D_MULTISAMPLE, sampled[unit]);
  }
  glActiveTexture(GL_TEXTURE0 + sampled.size());
  glBindTexture(GL_TEXTURE_2D, occlusions_);
  glActiveTexture(GL_TEXTURE0);
}

}  // namespace burnish
