#pragma once

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
};

struct Button {
  std::string_view name;
  std::string_view hint = {};
  bool is_wide = true;
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
  /// Shows text that is less important. Empty: nothing.
  virtual void text(std::string_view text) = 0;
  virtual SliderChange slider(const Slider& slider, double& value) = 0;
  /// Returns whether it is pressed.
  virtual bool button(const Button& button) = 0;
  /// Returns the word that the user chooses; mostly empty.
  virtual std::string_view choice(const Choice& choice, std::string_view chosen) = 0;
  /// Shows a ball on which the lamp is dragged: the middle is the eye, the rim the picture's plane.
  virtual void lamp(Lighting& lighting) = 0;
};

}  // namespace burnish
