#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include "client/scene/camera.h"
#include "common/edit/edit.h"

namespace burnish {

/// Writes what is done as lines that `burnish --script` does again. Without a file it does nothing.
class Recorder {
 public:
  /// Fails: as errno says.
  Status open(const std::filesystem::path& path);

  void record(const std::string& line);
  /// Cell fields have no line: they come from other programs.
  void record(const Edit& edit);
  void record(const Camera& camera);

 private:
  std::ofstream file_;
};

}  // namespace burnish
