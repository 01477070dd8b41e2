#pragma once

#include <memory>

#include "common/base/status.h"

namespace burnish {

/// OpenGL 3.3 core, or OpenGL ES 3.0, which browsers have.
enum class GlKind { kDesktop, kEmbedded };

/// An OpenGL context without a window. EGL makes it on Mesa's surfaceless platform, else
/// on the first device that has a driver. It is current on the thread that made it.
class EglContext {
 public:
  /// Fails: unavailable, with the missing part: the EGL library, a driver, or OpenGL 3.3.
  static Result<std::unique_ptr<EglContext>> create(GlKind kind = GlKind::kDesktop);
  ~EglContext();
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;

 private:
  EglContext(void* display, void* context) : display_(display), context_(context) {}

  void* display_;  // EGLDisplay
  void* context_;  // EGLContext
};

}  // namespace burnish
