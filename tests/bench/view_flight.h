#pragma once

#include "tests/bench/viewer.h"

namespace burnish {

/// Flies over the scan: to a point of it, near enough for its own triangles, and on to the next.
/// Leaves fetched_mb to the caller. Fails: internal_error when a picture has no surface.
Result<FlightFigures> fly(Viewer& viewer, double minutes);

}  // namespace burnish
