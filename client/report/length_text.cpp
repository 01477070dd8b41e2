#include "client/report/length_text.h"

#include <cstdio>

namespace burnish {

std::string length_text(double length, const std::string& unit) {
  char number[32];
  std::snprintf(number, sizeof number, "%.3g", length);
  return unit.empty() ? number : number + (" " + unit);
}

}  // namespace burnish
