#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "client/model/tasks/tasks.h"
#include "common/base/status.h"

namespace burnish {

/// A question for a file.
struct FileQuestion {
  enum class Purpose { kOpen, kSave };
  Purpose purpose = Purpose::kOpen;
  std::string title;
  std::vector<std::string> extensions;  ///< ".ply", lower case; empty: all files
  std::filesystem::path start;          ///< folder, or the suggested file of kSave
};

/// Returns the command of the desktop's file dialog, zenity or kdialog; empty if $PATH has none.
std::vector<std::string> native_dialog(const FileQuestion& question);

/// Runs such a command and waits for the answer; nothing if the user cancels. A stop ends the
/// program. Fails: as errno says; unavailable if the program fails.
Result<std::optional<std::filesystem::path>> ask_natively(const std::vector<std::string>& command,
                                                          const StopToken& stop);

}  // namespace burnish
