#pragma once

#include <optional>

#include "client/app/widgets/panel.h"
#include "client/model/files/file_browser.h"
#include "client/model/tasks/tasks.h"
#include "client/model/workspace/letters.h"

namespace burnish {

/// Asks for a file: with the desktop's dialog where there is one, otherwise with a panel of its
/// own.
class FileDialog : public Panel {
 public:
  using Take = std::function<void(const std::filesystem::path&)>;

  /// A question with an empty start begins in the folder that was used last. Ignored while another
  /// question is open.
  void ask(FileQuestion question, const Preferences& preferences, Take take);
  bool is_open() const { return browser_.has_value() || is_asking_natively_; }
  void draw(Workspace& workspace) override;
  /// Adds the letters of the names that it shows.
  void add_letters(Letters& letters) const;

 private:
  void ask_desktop(const std::vector<std::string>& command);
  void draw_browser(Workspace& workspace);
  void draw_places(const Workspace& workspace);
  void draw_files();
  void draw_field();
  void take(const std::filesystem::path& file, Workspace& workspace);

  std::optional<FileBrowser> browser_;
  std::optional<std::filesystem::path> answer_;
  Take take_;
  bool is_new_ = false;  // the popup is not open yet
  bool is_unwanted_ = false;
  bool wants_keyboard_ = false;  // the field takes the keyboard again
  bool follows_chosen_ = false;  // the list scrolls to the chosen entry
  bool is_asking_natively_ = false;
  std::string problem_;  // of the desktop's dialog
  Tasks tasks_;          // last: its threads end first
};

}  // namespace burnish
