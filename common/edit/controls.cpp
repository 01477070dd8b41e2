#include "common/edit/controls.h"

#include <cmath>
#include <cstdio>

#include "common/base/limits.h"

namespace burnish {

std::string text_of(const Controls& controls) {
  char cap[32] = "";
  if (controls.cap > 0) std::snprintf(cap, sizeof cap, ", at most %g", controls.cap);
  return (controls.pin_rims ? "rims pinned" : "rims free") + std::string(cap) +
         (controls.keep_volume ? ", volume kept" : "");
}

bool is_volume_kept(double volume) {
  return std::abs(volume - 1) <= 1e-6;
}

std::string lost_volume_text(double volume, const Controls& controls) {
  if (!controls.keep_volume || is_volume_kept(volume)) return "";
  char text[160];
  std::snprintf(text, sizeof text, "the volume is %.6g %% of the scan's: %s", 100 * volume,
                controls.cap > 0 ? "the largest move wins over it"
                                 : "the edited part cannot grow enough to give it back");
  return text;
}

Status check_controls(const Controls& controls) {
  if (controls.cap >= 0 && controls.cap <= kCoordinateMagnitudeMax) return Status::ok();
  char text[64];
  std::snprintf(text, sizeof text, "cap %g is outside 0 to %g", controls.cap,
                kCoordinateMagnitudeMax);
  return invalid_argument(text);
}

}  // namespace burnish
