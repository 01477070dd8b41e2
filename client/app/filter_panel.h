#pragma once

#include "client/app/panel.h"

namespace burnish {

/// Gradient scale, fidelity and presets: what is done where nobody painted.
class FilterPanel : public Panel {
 public:
  void draw(Workspace& workspace) override;
};

}  // namespace burnish
