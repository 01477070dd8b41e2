#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "common/base/status.h"
#include "common/base/types.h"
#include "common/mesh/reading/text_scanner.h"

namespace burnish {

class OddVertices;

/// Returns the token in quotes, shortened, with unprintable bytes as '?': safe in a message.
std::string in_quotes(std::string_view token);

/// Returns the shortest decimal form, e.g. 1e+30 or nan.
std::string number_text(double value);

/// Returns all digits of an integer: 4000000000, not 4e+09.
std::string integer_text(double value);

bool equals_ignoring_case(std::string_view a, std::string_view b);

/// Parses the whole token; a leading + is allowed. "nan" and "inf" count as numbers, and so do
/// "1.#QNAN" and its kin, which count as NaN.
bool parse_double(std::string_view token, double& value);
bool parse_integer(std::string_view token, int64_t& value);

/// Returns true if the decimal number has more precision than a float: rounding to float moves it
/// by more than one unit of its last printed digit. A number printed from a float never counts,
/// whatever its number of digits; 512345.678 does.
bool exceeds_float(std::string_view token, double value);

/// Returns false for NaN, infinities and values beyond kCoordinateMagnitudeMax.
bool is_coordinate(double value);

/// Returns the exponent of ten of a decimal number's last digit: -3 for 1.250, 1 for 1.2e2.
int last_digit_exponent(std::string_view token);

/// The element whose coordinates are read, for messages: {"vertex", 7}.
struct ElementName {
  const char* kind;
  uint64_t number;
};

/// "vertex 7: y = nan; coordinates must be finite and within ±1e18".
std::string coordinate_complaint(ElementName element, int axis, const std::string& value);

using PositionWords = std::array<std::string_view, 3>;

inline PositionWords next_position_words(TextScanner& scanner) {
  const std::string_view x = scanner.next_token(), y = scanner.next_token();
  return {x, y, scanner.next_token()};
}

/// Parses three coordinates into `position`. Sets `has_doubles` if one exceeds_float(). Numbers
/// that are no coordinates go to `odd`, or are refused if there is none.
Status parse_position(const PositionWords& words, const TextScanner& scanner, ElementName element,
                      OddVertices* odd, Vec3d& position, bool& has_doubles);

}  // namespace burnish
