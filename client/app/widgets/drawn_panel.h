#pragma once

#include "client/app/widgets/panel.h"
#include "client/panels/panels.h"

namespace burnish {

/// Draws a panel that the page has too.
class DrawnPanel : public Panel {
 public:
  explicit DrawnPanel(const SharedPanel& panel) : panel_(panel) {}
  void draw(Workspace& workspace) override;

 private:
  const SharedPanel& panel_;
};

}  // namespace burnish
