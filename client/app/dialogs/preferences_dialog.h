#pragma once

#include "client/app/widgets/panel.h"

namespace burnish {

/// The settings that the window keeps.
class PreferencesDialog : public Panel {
 public:
  void open() { opening_ = true; }
  void draw(Workspace& workspace) override;

 private:
  bool opening_ = false;
};

}  // namespace burnish
