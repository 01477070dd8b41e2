#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "client/app/window/panels_copy.h"
#include "client/app/window/pen.h"
#include "client/model/input/input_queue.h"
#include "client/model/view/viewport.h"
#include "client/scene/image.h"
#include "common/base/status.h"

struct GLFWwindow;

namespace burnish {

/// The looks of the panels.
struct WindowLook {
  double scale = 0;  ///< of letters and panels; 0: the screen's
  bool is_light = false;
  std::set<char16_t> letters;  ///< besides Latin, Greek and Cyrillic
  bool operator==(const WindowLook&) const = default;
};

/// Events of the window, in the order of the user's acts. Pixels are the framebuffer's, from its
/// upper left corner.
struct WindowEvents {
  std::function<void(PointerButton, Modifiers, const Eigen::Vector2d&)> press;
  std::function<void(PointerButton)> release;
  std::function<void(const Eigen::Vector2d&)> move;
  /// Comes before each press and move: the pressure of the pen that draws, 0 to 1.
  std::function<void(std::optional<double> pressure)> pen;
  std::function<void(const Eigen::Vector2d&, double steps)> wheel;
  std::function<void(const std::string& key)> key;  ///< in the form of Bindings
  std::function<void(bool held)> space;
  std::function<void(std::vector<std::filesystem::path>)> drop;
};

/// A window with ImGui and an OpenGL 3.3 core context, which is current on this thread. Needs: one
/// window at a time.
class Window {
 public:
  /// Fails: unavailable (no display, no driver).
  static Result<std::unique_ptr<Window>> create(const ImageSize& size, const WindowLook& look,
                                                WindowEvents events);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  /// Returns true if the user or close() has asked to close the window since the last call.
  bool take_close_request();
  void close();
  /// Removes the window from the screen at once; its contents stay alive.
  void hide();

  /// Waits until something happens, at most `seconds`.
  void wait(double seconds);
  /// Returns true if something has happened since the last call, so that a picture is due.
  bool take_dirty() { return std::exchange(dirty_, false); }

  /// Hands the next step of input to the events and to ImGui. Call once per picture, before it.
  void deliver();

  ImageSize framebuffer_size() const;  ///< 0x0 while it is minimised
  ImageSize size() const;              ///< in the screen's coordinates
  void set_title(const std::string& title);

  /// Changes the looks if they are others. Call it between frames. Returns letters of scripts that
  /// no font here has; empty: all are drawn.
  std::string set_look(const WindowLook& look);

  /// Begin and end ImGui's frame. The end returns whether its panels differ from those on the
  /// screen, or the screen has lost them.
  void begin_frame();
  bool end_frame();
  /// Draws the panels over the content of the framebuffer, and puts it on the screen.
  void show_frame();

  /// Ends wait(). Any thread may call it.
  static void wake();

 private:
  Window(GLFWwindow* window, WindowEvents events) : window_(window), events_(std::move(events)) {}
  friend struct WindowCallbacks;
  Eigen::Vector2d to_pixels(const Eigen::Vector2d& place) const;
  void deliver(const InputEvent& event);
  void deliver_button(const InputEvent& event);
  void deliver_key(const InputEvent& event);
  void deliver_character(int code);

  GLFWwindow* window_;
  WindowEvents events_;
  std::optional<WindowLook> look_;
  InputQueue input_;  // in the screen's coordinates
  Pen pen_;
  bool dirty_ = true;
  bool is_lost_ = true;  // the screen lacks the last picture
  PanelsCopy panels_;
};

}  // namespace burnish
