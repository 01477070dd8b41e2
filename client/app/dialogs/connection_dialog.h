#pragma once

#include "client/app/widgets/panel.h"
#include "client/model/settings/known_servers.h"

namespace burnish {

/// Asks for a server: its address, how to trust it, and who the user is there.
class ConnectionDialog : public Panel {
 public:
  void open() { opening_ = true; }
  void draw(Workspace& workspace) override;

 private:
  void draw_known(Workspace& workspace);
  void draw_fields();
  void draw_state(const Library& library) const;
  void connect(Workspace& workspace);

  bool opening_ = false;
  bool is_entered_ = false;  // Enter in a field
  std::string asked_;        // the address that the dialog connects to; empty: none yet
  ConnectionForm form_;
  FormProblems problems_;
};

}  // namespace burnish
