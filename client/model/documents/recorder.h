#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "client/scene/camera.h"
#include "common/edit/edit.h"

namespace burnish {

/// Records the user's actions as lines that `burnish --script` can run: the edits have the same
/// bits then. Does nothing until it is opened.
class Recorder {
 public:
  /// Takes a line without its end.
  using Sink = std::function<void(const std::string& line)>;

  /// Records to a file. Fails: as errno says.
  Status open(const std::filesystem::path& path);
  void open(Sink sink) { sink_ = std::move(sink); }
  void close() { sink_ = nullptr; }
  bool is_open() const { return sink_ != nullptr; }

  void record(const std::string& line);
  /// Records an edit. Cell fields have no line: they come from other programs.
  void record(const Edit& edit);
  void record(const Camera& camera);

 private:
  Sink sink_;
};

}  // namespace burnish
