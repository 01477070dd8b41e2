#include "client/gl/context_egl.h"

#include <array>
#include <dlfcn.h>
#include <vector>

#include <epoxy/egl.h>
#include <epoxy/gl.h>

namespace burnish {
namespace {

constexpr const char* kAdvice =
    "; pictures need EGL and an OpenGL 3.3 driver (Debian: libegl1 libegl-mesa0 libgl1-mesa-dri)";

Status no_context(const std::string& reason) {
  return unavailable("no OpenGL context: " + reason + kAdvice);
}

template <typename Function>
Function egl_extension(const char* name) {
  return reinterpret_cast<Function>(eglGetProcAddress(name));
}

std::vector<EGLDeviceEXT> egl_devices() {
  const auto query = egl_extension<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
  std::array<EGLDeviceEXT, 16> devices;
  EGLint count = 0;
  if (query == nullptr || !query(EGLint(devices.size()), devices.data(), &count)) count = 0;
  return {devices.begin(), devices.begin() + count};
}

// Returns displays that need no window system, the best first.
std::vector<EGLDisplay> candidate_displays() {
  const auto get_display =
      egl_extension<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
  std::vector<EGLDisplay> displays;
  if (get_display == nullptr) return displays;
  displays.push_back(get_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
  for (EGLDeviceEXT device : egl_devices())
    displays.push_back(get_display(EGL_PLATFORM_DEVICE_EXT, device, nullptr));
  std::erase(displays, EGL_NO_DISPLAY);
  return displays;
}

constexpr EGLint kDesktopVersion[] = {EGL_CONTEXT_MAJOR_VERSION,
                                      3,
                                      EGL_CONTEXT_MINOR_VERSION,
                                      3,
                                      EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                      EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                      EGL_NONE};
constexpr EGLint kEmbeddedVersion[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_NONE};

EGLContext make_context(EGLDisplay display, GlKind kind) {
  const bool is_desktop = kind == GlKind::kDesktop;
  if (!eglBindAPI(is_desktop ? EGL_OPENGL_API : EGL_OPENGL_ES_API)) return EGL_NO_CONTEXT;
  const EGLContext context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT,
                                              is_desktop ? kDesktopVersion : kEmbeddedVersion);
  if (context == EGL_NO_CONTEXT) return context;
  if (eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context)) return context;
  eglDestroyContext(display, context);
  return EGL_NO_CONTEXT;
}

}  // namespace

Result<std::unique_ptr<EglContext>> EglContext::create(GlKind kind) {
  // libepoxy ends the process when it cannot load the library, so this tries first. The library
  // stays loaded.
  if (dlopen("libEGL.so.1", RTLD_LAZY | RTLD_GLOBAL) == nullptr)
    return no_context("the library libEGL.so.1 is missing");
  const std::vector<EGLDisplay> displays = candidate_displays();
  if (displays.empty()) return no_context("EGL offers no display without a window");
  for (EGLDisplay display : displays) {
    if (!eglInitialize(display, nullptr, nullptr)) continue;
    const EGLContext context = make_context(display, kind);
    if (context != EGL_NO_CONTEXT)
      return std::unique_ptr<EglContext>(new EglContext(display, context));
    eglTerminate(display);
  }
  return no_context("none of the " + std::to_string(displays.size()) +
                    " EGL displays here has a driver for OpenGL 3.3 core");
}

EglContext::~EglContext() {
  eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext(display_, context_);
  // The display stays open: EGL has one per process, and other contexts may use it.
}

}  // namespace burnish
