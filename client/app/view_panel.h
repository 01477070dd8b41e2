#pragma once

#include "client/app/panel.h"

namespace burnish {

/// Settings of how the surface is shown.
class ViewPanel : public Panel {
 public:
  void draw(Workspace& workspace) override;
};

}  // namespace burnish
