#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "client/model/files/file_list.h"
#include "client/model/files/native_dialog.h"

namespace burnish {

/// The state of a file dialog: a folder, the text that the user types, and the chosen entry. Text
/// that begins with "/" or "~" is a path. Other text filters the list when a file is opened, and
/// names the file when one is saved.
class FileBrowser {
 public:
  /// Begins in the question's folder, or in the home folder if there is none.
  explicit FileBrowser(FileQuestion question);

  const FileQuestion& question() const { return question_; }
  const std::filesystem::path& folder() const { return folder_; }
  /// Returns why the last step failed; empty: it did not.
  const std::string& problem() const { return problem_; }
  /// Returns true if the next enter() replaces a file.
  bool replaces() const { return replaces_; }

  const std::string& typed() const { return typed_; }
  void type(const std::string& text);

  /// Returns the entries that fit the typed text.
  std::vector<ListedFile> shown() const;
  /// Returns the name of the chosen entry; empty: none.
  const std::string& chosen() const { return chosen_; }
  void choose(const ListedFile& file);
  /// Chooses the next entry, or the one before.
  void move(int by);

  void go(const std::filesystem::path& folder);
  void up() { go(folder_.parent_path()); }

  /// Takes the typed path, the chosen entry, or the first one that fits. Returns a file, or
  /// nothing: it went into a folder, asks about a file that is there, or failed.
  std::optional<std::filesystem::path> enter();

 private:
  bool saves() const { return question_.purpose == FileQuestion::Purpose::kSave; }
  std::optional<std::filesystem::path> enter_path(const std::filesystem::path& path);
  std::optional<std::filesystem::path> enter_entry();
  std::optional<std::filesystem::path> save_as(std::filesystem::path path);

  FileQuestion question_;
  std::filesystem::path folder_;
  std::vector<ListedFile> files_;
  std::string typed_;
  std::string chosen_;
  std::string problem_;
  bool replaces_ = false;
};

}  // namespace burnish
