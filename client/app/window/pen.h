#pragma once

#include <optional>
#include <string>

#include "client/tools/pen_pressure.h"

namespace burnish {

/// Tells how hard a pen presses on its tablet while it draws. Needs: glfwInit(), on its thread.
class Pen {
 public:
  /// Return the pressure, 0 to 1: at the press of the left button, and during that gesture.
  /// Nothing: no pen touches its tablet.
  std::optional<double> begin();
  std::optional<double> go_on();
  void end() { gesture_.end(); }

  /// Returns why pens have no pressure here, for people; empty: they have.
  static std::string lack();

 private:
  PenGesture gesture_;
};

}  // namespace burnish
