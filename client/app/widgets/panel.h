#pragma once

#include "client/model/workspace/workspace.h"

namespace burnish {

/// A part of the window. Draws with ImGui, and holds only text that the user is typing.
class Panel {
 public:
  virtual ~Panel() = default;
  virtual void draw(Workspace& workspace) = 0;
};

}  // namespace burnish
