#pragma once

#include <string>

#include "common/measure/deviation.h"

namespace burnish {

/// Returns a length with its sign: "+0.12 mm", "-42.7 m", "0".
std::string signed_length_text(double length, const std::string& unit);

/// Returns "at most -42.7 m, mean +0.031 m, rms 6.61 m". `unit`: the scan's.
std::string moves_text(const AxisMoves& moves, const std::string& unit);

}  // namespace burnish
