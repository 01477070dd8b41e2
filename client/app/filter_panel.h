#pragma once

#include "client/app/panel.h"

namespace burnish {

/// Gradient scale, fidelity and presets: the edit outside of painted areas.
class FilterPanel : public Panel {
 public:
  void draw(Workspace& workspace) override;
};

}  // namespace burnish
