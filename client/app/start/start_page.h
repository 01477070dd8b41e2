#pragma once

#include <string>
#include <utility>

#include "client/app/dialogs/connection_dialog.h"
#include "client/app/start/session_cards.h"
#include "client/app/widgets/panel.h"

namespace burnish {

/// The page while no session is open: a scan to open, recent sessions, the server and its scans.
class StartPage : public Panel {
 public:
  void draw(Workspace& workspace) override;
  /// Returns true if the user wants to choose a file since the last call.
  bool take_open_wish() { return std::exchange(wants_to_open_, false); }

 private:
  void draw_open(Workspace& workspace);
  void draw_server(Workspace& workspace);

  bool wants_to_open_ = false;
  std::string file_;
  SessionCards cards_;
  ConnectionDialog connection_dialog_;
};

}  // namespace burnish
