#pragma once

#include "client/app/panel.h"

namespace burnish {

/// Who is here, and who may do what.
class PeoplePanel : public Panel {
 public:
  void draw(Workspace& workspace) override;
};

}  // namespace burnish
