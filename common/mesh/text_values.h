#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "common/base/status.h"
#include "common/base/types.h"
#include "common/mesh/text_scanner.h"

namespace burnish {

/// Returns the token in quotes, shortened, with unprintable bytes as '?': safe in a message.
std::string in_quotes(std::string_view token);

/// Returns the shortest decimal form, e.g. 1e+30 or nan.
std::string number_text(double value);

/// Returns all digits of an integer: 4000000000, not 4e+09.
std::string integer_text(double value);

bool equals_ignoring_case(std::string_view a, std::string_view b);

/// Parses the whole token; a leading + is allowed. "nan" and "inf" count as numbers.
bool parse_double(std::string_view token, double& value);
bool parse_integer(std::string_view token, int64_t& value);

/// Returns true if the decimal number has more precision than a float: rounding to float moves it
/// by more than one unit of its last printed digit. A number printed from a float never counts,
/// whatever its number of digits; 512345.678 does.
bool exceeds_float(std::string_view token, double value);

/// Returns false for NaN, infinities and values beyond kCoordinateMagnitudeMax.
bool is_coordinate(double value);

/// The element whose coordinates are read, for messages: {"vertex", 7}.
struct ElementName {
  const char* kind;
  uint64_t number;
};

/// "vertex 7: y = nan; coordinates must be finite and within ±1e18".
std::string coordinate_complaint(ElementName element, int axis, const std::string& value);

/// Reads three coordinates from the current line into `position`. Sets `has_doubles` if one
/// exceeds_float().
Status read_position(TextScanner& scanner, ElementName element, Vec3d& position, bool& has_doubles);

}  // namespace burnish
