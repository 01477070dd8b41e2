#pragma once

#include <string>
#include <string_view>

namespace burnish {

/// The digits that the coordinates of a text have. A text with more digits than a float, as surveys
/// write them, is written with these digits again: "499907.356" has three decimals, and no
/// coordinate of such a file gets a fourth. Programs print a number of decimals or a number of
/// digits; both are known by the most that a coordinate has.
class TextDigits {
 public:
  /// Adds a coordinate of the file.
  void add(std::string_view token);

  /// Returns whether one of them has more digits than a float.
  bool exceed_float() const { return exceed_float_; }

  /// Returns the number as the file would have it. `before` is the coordinate in the file.
  double kept(double value, double before) const;

  /// Returns the distance of two numbers that the file can have there.
  double step(double before) const;

  /// Returns the text of a number that the file can have, in the form of the old text.
  std::string text_of(double value, double before, std::string_view old) const;

 private:
  int decimals_of(double before) const;

  int decimals_ = -400;
  int digits_ = 1;
  bool exceed_float_ = false;
};

}  // namespace burnish
