#include "client/model/input/typed_number.h"

#include <algorithm>
#include <cmath>

#include "common/base/fixed_text.h"
#include "common/base/text_lines.h"

namespace burnish {

static std::string trimmed(const std::string& text) {
  const size_t first = text.find_first_not_of(' ');
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(' ') - first + 1);
}

static std::string short_number(double number) {
  constexpr int kDigits = 3;
  return fixed_text(number, kDigits);
}

Result<TypedNumber> read_typed_number(const TypedValue& value, const std::string& text) {
  std::string word = trimmed(text);
  std::replace(word.begin(), word.end(), ',', '.');
  const auto number = parse_real(word);
  if (!number.is_ok() || !std::isfinite(*number))
    return invalid_argument(value.name + ": '" + text + "' is not a number");
  TypedNumber typed{std::clamp(*number, value.low, value.high), {}};
  if (typed.value != *number)
    typed.note = value.name + " " + short_number(*number) + " is outside " +
                 short_number(value.low) + ".." + short_number(value.high) + ": it is now " +
                 short_number(typed.value);
  return typed;
}

}  // namespace burnish
