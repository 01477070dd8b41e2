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
  bool start_export(Workspace& workspace);

  bool opening_ = false;
  bool open_ = false;
  std::string session_;  // that path_ is for
  std::string path_;
  bool asks_ = false;  // whether to replace the file
  bool exact_ = false;
  bool with_record_ = true;
};

}  // namespace burnish
