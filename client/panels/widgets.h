#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "client/scene/lighting.h"

namespace burnish {

enum class SliderChange {
  kStill,
  kMoving,  ///< the value changed and may change again
  kDone,    ///< the value is what the user wants
};

/// How a slider's places become values.
enum class SliderScale : uint8_t {
  kLinear,
  kLogarithmic,
  kBeta,  ///< the left half smooths, the right half sharpens, up to kBetaMax; blue and red
};

// Texts last as long as the call.

struct Slider {
  const char* name;  ///< as every widget's, unique in its panel
  const char* hint;
  double low, high;
  SliderScale scale = SliderScale::kLinear;
  uint8_t digits = 3;  ///< of the number; 0: two decimals
  bool has_title = true;
  const char* note = "";  ///< behind the title
};

enum class Pressed { kIsNoSwitch, kNo, kYes };

struct Option {
  const char* word;
  const char* label;
  const char* hint = "";
};

struct Choice {
  const char* name;
  std::span<const Option> options;
  const char* otherwise = "";  ///< the label while none of them is chosen
  const char* hint = "";       ///< empty: that of the chosen option
  bool is_labelled = false;    ///< the name stands before it
};

/// Takes the widgets of a panel, from above, and says what the user does with them. The window
/// draws them, the page's core writes them, and a line of the page is done by one of them.
class Widgets {
 public:
  virtual ~Widgets() = default;

  /// Says whether the widgets that follow can be used. At first they can.
  virtual void enable(bool on) = 0;
  /// Lets the widgets up to end_row() stand beside each other, each as wide.
  virtual void begin_row(int columns) = 0;
  virtual void end_row() = 0;
  /// Shows text that is less important; empty: nothing. `is_announced`: to readers of the screen.
  virtual void text(const char* text, const char* hint = "", bool is_announced = false) = 0;
  virtual SliderChange slider(const Slider& slider, double& value) = 0;
  /// Returns whether the user presses it. An empty label is the name.
  virtual bool button(const char* name, const char* hint = "",
                      Pressed pressed = Pressed::kIsNoSwitch, const char* label = "") = 0;
  /// Returns whether the user switches it.
  virtual bool check(const char* name, const char* hint, bool& on) = 0;
  /// Takes and returns the number of an option; -1: none. Mostly the user chooses none.
  virtual int choice(const Choice& choice, int chosen) = 0;
  /// Shows a ball on which the lamp is dragged: the middle is the eye, the rim the picture's plane.
  virtual void lamp(Lighting& lighting) = 0;
};

}  // namespace burnish
