#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "client/scene/lighting.h"

namespace burnish {

enum class SliderChange {
  kStill,
  kMoving,  ///< the value changed and may change again
  kDone,    ///< the value is what the user wants
};

/// How a slider's places become values.
enum class SliderScale {
  kLinear,
  kLogarithmic,
  kBeta,  ///< the left half smooths, the right half sharpens, up to kBetaMax; blue and red
};

struct Slider {
  std::string_view name;  ///< as every widget's, unique in its panel
  std::string_view hint;
  double low, high;
  SliderScale scale = SliderScale::kLinear;
  bool has_two_decimals = false;  ///< else three digits
  bool has_title = true;
  std::string_view note = {};  ///< behind the title
};

struct Button {
  std::string_view name;
  std::string_view hint = {};
  std::string_view label = {};  ///< empty: the name
  std::optional<bool> is_pressed = {};
};

struct Check {
  std::string_view name;
  std::string_view hint = {};
};

/// Text that is less important. Empty: nothing.
struct Text {
  std::string_view text;
  std::string_view hint = {};
  bool is_announced = false;  ///< to readers of the screen, when it changes
};

struct Option {
  std::string_view word;
  std::string_view label;
  std::string hint = {};
};

struct Choice {
  std::string_view name;
  std::span<const Option> options;
  std::string_view otherwise = {};  ///< the label while none of them is chosen
  std::string_view hint = {};       ///< empty: that of the chosen option
  bool is_labelled = false;         ///< the name stands before it
};

/// Returns the option with this word; null if there is none.
const Option* find_option(const Choice& choice, std::string_view word);

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
  virtual void text(const Text& text) = 0;
  virtual SliderChange slider(const Slider& slider, double& value) = 0;
  /// Returns whether it is pressed.
  virtual bool button(const Button& button) = 0;
  /// Returns whether it is switched.
  virtual bool check(const Check& check, bool& on) = 0;
  /// Returns the word that the user chooses; mostly empty.
  virtual std::string_view choice(const Choice& choice, std::string_view chosen) = 0;
  /// Shows a ball on which the lamp is dragged: the middle is the eye, the rim the picture's plane.
  virtual void lamp(Lighting& lighting) = 0;
};

}  // namespace burnish
