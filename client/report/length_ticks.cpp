#include "client/report/length_ticks.h"

#include <cmath>

#include "client/report/length_text.h"
#include "common/base/round_number.h"

namespace burnish {

std::vector<LengthTick> length_ticks(double low, double high, double apart,
                                     const std::string& unit) {
  constexpr double kRatioMax = 2.5;  // of two round numbers that follow each other
  constexpr double kTicksMax = 200;
  std::vector<LengthTick> ticks;
  if (!std::isnormal(apart) || apart < 0 || !((high - low) / apart <= kTicksMax)) return ticks;
  const double step = round_number_below(kRatioMax * apart);
  const double first = std::ceil(low / step) + 0.0;  // not -0
  const double last = std::floor(high / step);
  for (double i = first; i <= last; ++i)
    ticks.push_back({i * step, length_text(i * step, i == last ? unit : "", kRulerDigits)});
  return ticks;
}

}  // namespace burnish
