#pragma once

#include <string>

namespace burnish {

/// Returns a length with three digits and its unit: "0.0123 mm". An empty unit is left out.
std::string length_text(double length, const std::string& unit);

}  // namespace burnish
