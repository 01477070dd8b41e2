#pragma once

#include <imgui.h>

#include "client/app/widgets/panel.h"

namespace burnish {

/// Figures of the newest frame and of the link.
class FiguresPanel : public Panel {
 public:
  void draw(Workspace& workspace) override;
};

/// The state of the solver and of the link, over the picture.
class Hud : public Panel {
 public:
  void draw(Workspace& workspace) override;

  ImVec2 upper_right{0, 0};  ///< of the picture
  ImVec2 room{0, 0};         ///< size of the picture: a small one is not covered
  bool shows_figures = true;
};

}  // namespace burnish
