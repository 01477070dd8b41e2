#include "common/edit/controls.h"

#include <cstdio>

#include "common/base/limits.h"

namespace burnish {

std::string text_of(const Controls& controls) {
  char cap[32] = "";
  if (controls.cap > 0) std::snprintf(cap, sizeof cap, ", at most %g", controls.cap);
  return (controls.pin_rims ? "rims pinned" : "rims free") + std::string(cap) +
         (controls.keep_volume ? ", volume kept" : "");
}

Status check_controls(const Controls& controls) {
  if (controls.cap >= 0 && controls.cap <= kCoordinateMagnitudeMax) return Status::ok();
  char text[64];
  std::snprintf(text, sizeof text, "cap %g is outside 0 to %g", controls.cap,
                kCoordinateMagnitudeMax);
  return invalid_argument(text);
}

}  // namespace burnish
