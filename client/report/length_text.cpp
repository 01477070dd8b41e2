#include "client/report/length_text.h"

#include <cstdio>

namespace burnish {

std::string length_text(double length, const std::string& unit) {
  char number[32];
  std::snprintf(number, sizeof number, "%.3g", length);
  return unit.empty() ? number : number + (" " + unit);
}

std::string power_text(double value, const std::string& unit, int power) {
  if (unit.empty()) return length_text(value, unit);
  return length_text(value, unit + (power == 2 ? "²" : "³"));
}

}  // namespace burnish
