#pragma once

#include <imgui.h>

#include "client/app/widgets/panel.h"

namespace burnish {

/// The section through the original and the edited surface, with the ruler's way across the window.
class SectionWindow : public Panel {
 public:
  void draw(Workspace& workspace) override;

  /// The drawn area, which takes the mouse.
  ImVec2 covered_low{0, 0}, covered_high{0, 0};

 private:
  void draw_controls(Workspace& workspace);
  void save(const std::string& ending, Workspace& workspace);

  float exaggeration_ = 1;  // of heights
};

}  // namespace burnish
