#pragma once

#include "client/app/panel.h"

namespace burnish {

/// The people in the session and their roles.
class PeoplePanel : public Panel {
 public:
  void draw(Workspace& workspace) override;
};

}  // namespace burnish
