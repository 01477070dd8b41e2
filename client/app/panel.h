#pragma once

#include "client/model/workspace.h"

namespace burnish {

/// A part of the window. Draws by ImGui, and holds nothing but what is being typed into it.
class Panel {
 public:
  virtual ~Panel() = default;
  virtual void draw(Workspace& workspace) = 0;
};

}  // namespace burnish
