#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include "client/scene/camera.h"
#include "common/edit/edit.h"

namespace burnish {

/// Records the user's actions as lines that `burnish --script` can run. Does nothing without a
/// file.
class Recorder {
 public:
  /// Fails: as errno says.
  Status open(const std::filesystem::path& path);

  void record(const std::string& line);
  /// Records an edit. Cell fields have no line: they come from other programs.
  void record(const Edit& edit);
  void record(const Camera& camera);

 private:
  std::ofstream file_;
};

}  // namespace burnish
