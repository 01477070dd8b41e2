#pragma once

#include "client/app/panel.h"

namespace burnish {

/// The transfer curve over the histogram of curvature.
class CurvePanel : public Panel {
 public:
  void draw(Workspace& workspace) override;
};

}  // namespace burnish
