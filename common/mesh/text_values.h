#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "common/base/status.h"
#include "common/base/types.h"
#include "common/mesh/text_scanner.h"
#include "common/mesh/triangle_mesh.h"

namespace burnish {

/// The token in quotes, shortened and with unprintable bytes as '?': safe in a message.
std::string in_quotes(std::string_view token);

/// The shortest decimal form, e.g. 1e+30 or nan.
std::string number_text(double value);

/// All digits of a whole number: 4000000000, not 4e+09.
std::string integer_text(double value);

bool equals_ignoring_case(std::string_view a, std::string_view b);

/// Whole token or nothing; a leading + is allowed. "nan" and "inf" are numbers here.
bool parse_double(std::string_view token, double& value);
bool parse_integer(std::string_view token, int64_t& value);

/// True when the decimal number says more than a float can hold: rounding it to float moves it by
/// more than one unit of its last printed digit. So nothing that was printed from a float is
/// double, at any number of digits, while 512345.678 is.
bool exceeds_float(std::string_view token, double value);

/// False for NaN, infinities and what is beyond kCoordinateMagnitudeMax.
bool is_coordinate(double value);

/// The element whose coordinates are read, for messages: {"vertex", 7}.
struct ElementName {
  const char* kind;
  uint64_t number;
};

/// "vertex 7: y = nan; coordinates must be finite and within ±1e18".
std::string coordinate_complaint(ElementName element, int axis, const std::string& value);

/// Reads three coordinates from the current line into `position`; sets mesh.has_double_positions
/// where exceeds_float().
Status read_position(TextScanner& scanner, ElementName element, Vec3d& position,
                     TriangleMesh& mesh);

}  // namespace burnish
