#include "client/gl/picture_target.h"

#include <algorithm>

#include "client/gl/gl_error.h"
#include "client/gl/target_limits.h"

namespace burnish {

static void attach(GLenum attachment, GLuint buffer, GLint samples, GLenum format,
                   const ImageSize& size) {
  glBindRenderbuffer(GL_RENDERBUFFER, buffer);
  glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, size.width, size.height);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, buffer);
}

PictureTarget::PictureTarget() {
  glGenFramebuffers(1, &samples_);
  glGenFramebuffers(1, &resolved_);
  glGenRenderbuffers(1, &samples_colour_);
  glGenRenderbuffers(1, &samples_depth_);
  glGenRenderbuffers(1, &resolved_colour_);
}

PictureTarget::~PictureTarget() {
  glDeleteRenderbuffers(1, &resolved_colour_);
  glDeleteRenderbuffers(1, &samples_depth_);
  glDeleteRenderbuffers(1, &samples_colour_);
  glDeleteFramebuffers(1, &resolved_);
  glDeleteFramebuffers(1, &samples_);
}

Status PictureTarget::allocate(const ImageSize& size) {
  const std::string what = picture_name(size);
  RETURN_IF_ERROR(check_side(size, GL_MAX_RENDERBUFFER_SIZE));
  const GLint samples = std::min(kSamplesWanted, integer_limit(GL_MAX_SAMPLES));
  glBindFramebuffer(GL_FRAMEBUFFER, resolved_);
  attach(GL_COLOR_ATTACHMENT0, resolved_colour_, 0, GL_RGBA8, size);
  glBindFramebuffer(GL_FRAMEBUFFER, samples_);
  attach(GL_COLOR_ATTACHMENT0, samples_colour_, samples, GL_RGBA8, size);
  attach(GL_DEPTH_ATTACHMENT, samples_depth_, samples, GL_DEPTH_COMPONENT24, size);
  RETURN_IF_ERROR(check_gl(what));
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    return resource_exhausted(what + ": the graphics driver offers no such buffers");
  size_ = size;
  return Status::ok();
}

Status PictureTarget::bind(const ImageSize& size) {
  RETURN_IF_ERROR(check_image_size(size));
  if (size != size_) RETURN_IF_ERROR(allocate(size));
  glBindFramebuffer(GL_FRAMEBUFFER, samples_);
  glViewport(0, 0, size.width, size.height);
  return Status::ok();
}

void PictureTarget::bind_resolved() const {
  glBindFramebuffer(GL_FRAMEBUFFER, resolved_);
}

void PictureTarget::resolve() const {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, samples_);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved_);
  glBlitFramebuffer(0, 0, size_.width, size_.height, 0, 0, size_.width, size_.height,
                    GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

void PictureTarget::show(const Eigen::Vector2i& lower_left) const {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, resolved_);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
  glBlitFramebuffer(0, 0, size_.width, size_.height, lower_left.x(), lower_left.y(),
                    lower_left.x() + size_.width, lower_left.y() + size_.height,
                    GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

Result<Image> PictureTarget::read() const {
  if (size_ == ImageSize{}) return failed_precondition("nothing has been drawn yet");
  const size_t width = static_cast<size_t>(size_.width);
  std::vector<uint8_t> rgba(4 * width * size_.height);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, resolved_);
  glReadPixels(0, 0, size_.width, size_.height, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
  RETURN_IF_ERROR(check_gl("reading the picture"));
  Image image{size_, {}};
  image.rgb.reserve(3 * width * size_.height);
  for (int y = size_.height - 1; y >= 0; --y)  // OpenGL rows go up
    for (size_t x = 0; x < width; ++x) {
      const uint8_t* const pixel = rgba.data() + 4 * (width * y + x);
      image.rgb.insert(image.rgb.end(), pixel, pixel + 3);
    }
  return image;
}

}  // namespace burnish
