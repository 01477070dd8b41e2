#pragma once

#include <string>

namespace burnish {

/// Returns a length with three digits and its unit: "0.0123 mm". An empty unit is left out.
std::string length_text(double length, const std::string& unit);

/// Returns an area or a volume: power 2 or 3 of the unit, "12.3 mm²". Without a unit the number.
std::string power_text(double value, const std::string& unit, int power);

}  // namespace burnish
