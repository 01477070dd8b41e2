#pragma once

#include "client/app/panel.h"

namespace burnish {

/// The airbrush.
class BrushPanel : public Panel {
 public:
  void draw(Workspace& workspace) override;
};

}  // namespace burnish
