#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "client/scene/image.h"
#include "tests/common/temporary_folder.h"
#include "tests/system/process.h"

struct _XDisplay;

namespace burnish {

/// An X server without a screen. The test controls its mouse and keyboard (XTest).
class XDisplay {
 public:
  /// Returns false if Xvfb is not installed.
  static bool is_available();

  explicit XDisplay(const ImageSize& size);
  ~XDisplay();
  XDisplay(const XDisplay&) = delete;
  XDisplay& operator=(const XDisplay&) = delete;

  const std::string& name() const { return name_; }  ///< for DISPLAY

  /// Waits for the one window, and gives it the keyboard.
  void focus_window();
  /// Returns whether a window is visible.
  bool has_window();
  /// Returns the window's title, UTF-8.
  std::string title();
  void resize_window(const ImageSize& size);
  /// Closes the window like its close button.
  void close_window();

  void move(int x, int y);
  void press(int button);
  void release(int button);
  /// Presses at the first point, moves in steps to the second, and releases.
  void drag(int from_x, int from_y, int to_x, int to_y, int button = 1);
  /// Presses and releases keys by their names, and holds all but the last: key({"Control_L", "z"}).
  void key(const std::vector<std::string>& names);

  void hold(const std::string& name);
  void let_go(const std::string& name);

  /// Types text of ASCII on a US keyboard.
  void type(const std::string& text);

  /// Drops files on the middle of the window. Their names need no escapes.
  void drop(const std::vector<std::filesystem::path>& files);

  Image capture();

 private:
  unsigned long find_window();
  void flush();

  TemporaryFolder folder_;
  std::unique_ptr<Process> server_;
  std::string name_;
  ImageSize size_;
  _XDisplay* display_ = nullptr;
  unsigned long window_ = 0;
};

}  // namespace burnish
