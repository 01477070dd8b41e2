#pragma once

#include <concepts>
#include <cstdio>
#include <string>
#include <string_view>

#include "common/base/text.h"

namespace burnish {

/// Builds a line of words and numbers, as a stream does, without a stream's locales.
class LineText {
 public:
  /// For `digits`: as many as are read back as the same number.
  static constexpr int kExact = 0;

  /// `digits`: of numbers that are not whole.
  explicit LineText(int digits = 6) : digits_(digits) {}

  LineText& operator<<(std::string_view text) {
    text_ += text;
    return *this;
  }
  LineText& operator<<(char c) {
    text_ += c;
    return *this;
  }
  LineText& operator<<(double value) {
    if (digits_ == kExact) return *this << std::string_view(shortest_text(value));
    char digits[40];
    std::snprintf(digits, sizeof digits, "%.*g", digits_, value);
    return *this << std::string_view(digits);
  }
  template <std::integral Whole>
  LineText& operator<<(Whole value) {
    return *this << std::string_view(std::to_string(value));
  }

  const std::string& text() const { return text_; }

 private:
  int digits_;
  std::string text_;
};

}  // namespace burnish
