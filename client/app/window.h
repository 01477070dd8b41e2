#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "client/model/pointer_queue.h"
#include "client/model/viewport.h"
#include "client/scene/image.h"
#include "common/base/status.h"

struct GLFWwindow;

namespace burnish {

/// What the window tells. Pixels are the framebuffer's, from its upper left corner.
struct WindowEvents {
  std::function<void(PointerButton, Modifiers, const Eigen::Vector2d&)> press;
  std::function<void(PointerButton)> release;
  std::function<void(const Eigen::Vector2d&)> move;
  std::function<void(const Eigen::Vector2d&, double steps)> wheel;
  std::function<void(const std::string& key)> key;  ///< as Bindings writes it
  std::function<void(bool held)> space;
  std::function<void(std::vector<std::filesystem::path>)> drop;
};

/// A window with an OpenGL 3.3 core context, current on this thread, and ImGui in it. One at a
/// time.
class Window {
 public:
  /// `scale` 0: as the screen says. Fails: unavailable (no display, no driver).
  static Result<std::unique_ptr<Window>> create(const ImageSize& size, double scale,
                                                WindowEvents events);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  /// True when somebody wants it closed since the last call, be it the user or close().
  bool take_close_request();
  void close();
  /// From the screen, at once; what it holds lives on.
  void hide();

  /// Waits until something happens, or so long.
  void wait(double seconds);
  /// True when something happened since the last call: draw.
  bool take_dirty() { return std::exchange(dirty_, false); }

  ImageSize framebuffer_size() const;  ///< 0x0 while it is minimised
  ImageSize size() const;              ///< in the screen's coordinates
  void set_title(const std::string& title);

  /// ImGui's frame: everything between is drawn over what the framebuffer holds.
  void begin_frame();
  void end_frame();

  /// Ends the wait(). From any thread.
  static void wake();

 private:
  Window(GLFWwindow* window, WindowEvents events) : window_(window), events_(std::move(events)) {}
  friend struct WindowCallbacks;
  Eigen::Vector2d to_pixels(const Eigen::Vector2d& place) const;

  GLFWwindow* window_;
  WindowEvents events_;
  PointerQueue pointer_;  // in the screen's coordinates
  bool dirty_ = true;
};

}  // namespace burnish
