#pragma once

#include <string>
#include <string_view>

namespace burnish {

/// The digits that the numbers of a text have, and those that moved numbers get: "12.345" has three
/// decimals, and so has what replaces it. Programs print a number of decimals or a number of
/// digits; both are known by the most that a number has.
class TextDigits {
 public:
  /// Adds a number of the file.
  void add(std::string_view token);

  /// Adds decimals where the file's own are coarser than this step.
  void refine(double step_max);

  /// Gives no number more digits than a float has. Where a float is the coarser one, a number is
  /// the shortest text of a float.
  void limit_to_float() { is_float_ = true; }

  /// Gives small and large numbers the same decimals: the components of a normal change places.
  void ignore_magnitude() { digits_ = 400; }

  /// Returns the number as the file would have it. `before` is the number in the file.
  double kept(double value, double before) const;

  /// Returns the distance of two numbers around `kept` that the file can have there.
  double step(double kept, double before) const;

  /// Returns the text of a number that the file can have, in the form of the old text.
  std::string text_of(double kept, double before, std::string_view old) const;

 private:
  int decimals_of(double before) const;

  int decimals_ = -400;
  int digits_ = 1;
  int decimals_min_ = -400;
  bool is_float_ = false;
};

}  // namespace burnish
