#include "client/report/length_text.h"

#include "common/base/fixed_text.h"

namespace burnish {

std::string length_text(double length, const std::string& unit, int digits) {
  const std::string number = fixed_text(length, digits);
  return unit.empty() ? number : number + (" " + unit);
}

}  // namespace burnish
