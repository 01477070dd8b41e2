#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "client/connection/connection.h"
#include "client/connection/session_link.h"
#include "common/generate/generate.h"
#include "tests/system/places.h"
#include "tests/system/server_process.h"
#include "tests/system/sheet.h"
#include "tests/system/x_display.h"

namespace burnish {

inline constexpr ImageSize kWindow{1280, 720};  // at scale 1
inline constexpr int kWheelUp = 4, kWheelDown = 5;
inline constexpr const char* kLeft = "Left column";
inline constexpr const char* kRight = "Right column";

/// A window on a server with scans and people, and its user. Places in the picture are at scale 1.
class Studio {
 public:
  Studio(std::filesystem::path out, int scale, bool is_light);

  /// Opens a session in a window of its own. The last window ends.
  void open_window(const std::string& session);

  /// Generates a scan, imports it at its default depth, and opens it in a window of its own with
  /// these changes of `burnish edit`.
  void open_scan(const GeneratedScan& scan, const std::string& name,
                 const std::vector<std::string>& changes);

  void move(int x, int y);
  void press(int x, int y, int button = 1);
  void release(int button = 1);
  void click(int x, int y, int button = 1);
  void drag(int from_x, int from_y, int to_x, int to_y);
  void key(const std::vector<std::string>& names);
  void type(const std::string& text);

  // Use widgets by their names.
  Box place_of(const std::string& widget) const { return places_.wait_for(widget); }
  void hover(const std::string& widget);
  void click_on(const std::string& widget);
  /// Drags between two parts of a slider's width.
  void slide(const std::string& slider, double from, double to);
  /// Presses within a widget, in parts of its size, and moves. release() ends it.
  void press_in(const std::string& widget, const Eigen::Vector2d& from, const Eigen::Vector2d& to);
  /// Turns the wheel over a column until the whole section is seen.
  void scroll_to(const std::string& section, const char* column);
  void open_section(const std::string& section, const char* column, const std::string& widget);

  Image crop(const Box& box) { return cut(screen_.capture(), within_screen(box)); }
  /// Takes a picture at half size, for pictures without text.
  Image small(const Box& box) { return halved(crop(box)); }
  void save(const std::string& name, const Image& image) const;
  void save(const std::string& name, const Box& box) { save(name, crop(box)); }
  /// Saves a section, a dialog or another area with a margin around it.
  void save_area(const std::string& name, const std::string& area);
  Box whole() const { return {0, 0, scale_ * kWindow.width, scale_ * kWindow.height}; }
  /// Returns the picture between both columns.
  Box picture() const;
  /// Returns a part of the picture without figures and toasts.
  Box middle() const { return scaled({400, 260, 340, 300}, scale_); }
  /// Returns the lower left of the picture, where messages appear.
  Box toasts() const;
  Box with_margin(const Box& box, int margin) const;

  /// Shows or hides the figures over the picture.
  void toggle_figures();
  /// Moves the pointer to a place over nothing.
  void rest();

  /// Waits until the surface is at rest.
  void settle();

  /// Adds another user, who works at the right of the inscription.
  void let_bert_in();

  static void pause(int ms) { std::this_thread::sleep_for(std::chrono::milliseconds(ms)); }

 private:
  static constexpr int kMargin = 6;

  Box within_screen(const Box& box) const;
  void turn(int button, int count);
  bool is_whole(const std::string& section, const Box& column) const;
  static bool is_clay(const Image& image) {  // warm; panels and background are cold
    long warmth = 0;
    for (size_t i = 0; i < image.rgb.size(); i += 3) warmth += image.rgb[i] - image.rgb[i + 2];
    return warmth > 3 * static_cast<long>(image.rgb.size() / 3);
  }
  static void wait_until(const std::function<bool()>& holds);
  void write_scan(const GeneratedScan& scan, const std::string& name) const;
  // A scan with colours: bands, and stains between them.
  void write_painted(const std::string& name) const;
  void done(std::vector<std::string> words);
  std::string width() const { return std::to_string(scale_ * kWindow.width); }
  std::string height() const { return std::to_string(scale_ * kWindow.height); }

  const std::filesystem::path out_;
  const int scale_;
  ServerProcess server_;
  Connection connection_ = Connection::open(server_.address, kPatience).value();
  XDisplay screen_{{scale_ * kWindow.width, scale_* kWindow.height}};
  Places places_{server_.folder / "places"};
  std::unique_ptr<SessionLink> bert_;
  std::unique_ptr<Process> window_;
};

}  // namespace burnish
