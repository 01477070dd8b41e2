#pragma once

#include <imgui.h>

#include "client/app/widgets/panel.h"

namespace burnish {

/// The scale of the surface's colours, with the value under the pointer. Lies over the picture.
class ColourBar : public Panel {
 public:
  void draw(Workspace& workspace) override;

  ImVec2 lower_right = {0, 0};  ///< of the picture, in ImGui's units
  float top = 0;                ///< what draw() has left free above it
};

}  // namespace burnish
