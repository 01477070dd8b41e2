#pragma once

#include <string>

#include "client/app/panels.h"

namespace burnish {

/// The page while no session is open: servers, recent sessions, scans, import.
class StartPage : public Panel {
 public:
  void draw(Workspace& workspace) override;

 private:
  void draw_server(Workspace& workspace);
  void draw_recent(Workspace& workspace) const;
  void draw_import(Workspace& workspace);

  bool is_first_ = true;
  std::string server_;
  std::string file_;
};

}  // namespace burnish
