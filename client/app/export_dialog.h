#pragma once

#include <string>

#include "client/app/panels.h"

namespace burnish {

/// Asks where to write the edited scan.
class ExportDialog : public Panel {
 public:
  void open() { opening_ = true; }
  bool is_open() const { return opening_ || open_; }
  void draw(Workspace& workspace) override;

 private:
  bool opening_ = false;
  bool open_ = false;
  std::string path_;
  bool exact_ = false;
};

}  // namespace burnish
