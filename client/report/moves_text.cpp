#include "client/report/moves_text.h"

#include "client/report/length_text.h"

namespace burnish {

std::string signed_length_text(double length, const std::string& unit) {
  return (length > 0 ? "+" : "") + length_text(length, unit, kDeviationDigits);
}

std::string moves_text(const AxisMoves& moves, const std::string& unit) {
  return "at most " + signed_length_text(moves.farthest(), unit) + ", mean " +
         signed_length_text(moves.mean, unit) + ", rms " +
         length_text(moves.rms, unit, kDeviationDigits);
}

}  // namespace burnish
