#pragma once

#include "tests/bench/viewer.h"

namespace burnish {

/// Returns the bytes of the frames that come in five seconds while nothing changes.
Result<double> still_view_bytes(Viewer& viewer);

/// Drags the slider for some seconds, then waits for full detail.
Result<DragFigures> drag_slider(Viewer& viewer);

/// Paints a dab of 15 pixels in the middle of the picture.
Result<DabFigures> paint_dab(Viewer& viewer);

}  // namespace burnish
