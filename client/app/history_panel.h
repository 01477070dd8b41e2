#pragma once

#include <string>

#include "client/app/panel.h"

namespace burnish {

/// The session's edits, newest first. Each can be switched off.
class HistoryPanel : public Panel {
 public:
  void draw(Workspace& workspace) override;

 private:
  void draw_buttons(Document& document);
  void draw_checkpoint_row(Workspace& workspace);

  std::string checkpoint_name_;
};

}  // namespace burnish
