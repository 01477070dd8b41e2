#pragma once

#include <string>

namespace burnish {

/// Returns a number with so many significant digits, and with all digits before the point:
/// "0.0123", "1510". Below a millionth and from a million millions on it has an exponent.
std::string fixed_text(double number, int digits);

}  // namespace burnish
