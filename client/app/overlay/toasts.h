#pragma once

#include <imgui.h>

#include "client/app/widgets/panel.h"

namespace burnish {

/// New messages over the picture, and the progress of long work.
class Toasts : public Panel {
 public:
  void draw(Workspace& workspace) override;

  ImVec2 lower_left{0, 0};  ///< of the picture
  /// The drawn area, which takes the mouse.
  ImVec2 covered_low{0, 0}, covered_high{0, 0};
  bool is_visible(const Workspace& workspace) const;
};

/// All messages.
void draw_message_log(const MessageLog& log, bool& is_open);

}  // namespace burnish
