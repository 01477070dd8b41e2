#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>

#include "client/app/widgets/panel.h"
#include "client/model/files/native_dialog.h"

namespace burnish {

/// Asks where to write the edited scan.
class ExportDialog : public Panel {
 public:
  void open() { opening_ = true; }
  /// Opens with this file.
  void open(const std::filesystem::path& file);
  /// Returns the question for a file dialog if the user wants one since the last call.
  std::optional<FileQuestion> take_question() { return std::exchange(question_, std::nullopt); }
  bool is_open() const { return opening_ || open_; }
  void draw(Workspace& workspace) override;

 private:
  bool start_export(Workspace& workspace);

  bool opening_ = false;
  bool open_ = false;
  std::optional<FileQuestion> question_;
  std::string session_;  // that path_ is for
  std::string path_;
  bool is_path_chosen_ = false;  // by a file dialog
  bool asks_ = false;            // whether to replace the file
  bool exact_ = true;
  bool with_record_ = true;
};

}  // namespace burnish
