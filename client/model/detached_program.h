#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "common/base/status.h"

namespace burnish {

/// A program that runs on when this one ends, and when this one's terminal closes. It hears and
/// says nothing but its log.
class DetachedProgram {
 public:
  /// Starts `words[0]` with the rest as arguments; both outputs go to `log`, which is written anew.
  /// Files that it makes are for this user alone (umask 077). Its folder is the root, so paths are
  /// absolute. Fails: as errno says, but a program that cannot be run ends by itself.
  static Result<DetachedProgram> start(const std::vector<std::string>& words,
                                       const std::filesystem::path& log);
  DetachedProgram(DetachedProgram&& other) noexcept;
  DetachedProgram& operator=(DetachedProgram&&) = delete;
  ~DetachedProgram();

  bool has_ended() const;

 private:
  explicit DetachedProgram(int life) : life_(life) {}

  int life_;  // a pipe whose other end the program holds
};

}  // namespace burnish
