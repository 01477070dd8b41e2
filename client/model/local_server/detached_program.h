#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "common/base/status.h"

namespace burnish {

/// A program that keeps running when this program ends or its terminal closes. It reads no input
/// and writes only to its log.
class DetachedProgram {
 public:
  /// Starts `words[0]` with the rest as arguments; both outputs go to `log`, which is overwritten.
  /// Only this user can read the files that it makes (umask 077). Its folder is the root. Needs:
  /// absolute paths. Fails: as errno says. A program that cannot run is no failure here: it ends by
  /// itself.
  static Result<DetachedProgram> start(const std::vector<std::string>& words,
                                       const std::filesystem::path& log);
  DetachedProgram(DetachedProgram&& other) noexcept;
  DetachedProgram& operator=(DetachedProgram&&) = delete;
  ~DetachedProgram();

  bool has_ended() const;

 private:
  explicit DetachedProgram(int life) : life_(life) {}

  int life_;  // a pipe; the program holds its other end
};

}  // namespace burnish
