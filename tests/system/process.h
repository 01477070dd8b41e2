#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <sys/types.h>

namespace burnish {

/// A program under test, with both outputs in one file. The destructor kills it.
class Process {
 public:
  struct Limits {
    std::optional<uint64_t> file_bytes_max;     ///< RLIMIT_FSIZE: simulates a full disk
    std::optional<uint64_t> address_bytes_max;  ///< RLIMIT_AS: simulates little memory
  };

  /// Starts `words[0]` with the rest as arguments. Its output goes to `output`.
  Process(const std::vector<std::string>& words, std::filesystem::path output,
          const Limits& limits = {});
  ~Process();
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  /// Returns the exit code, 128 + the signal that ended it, or nothing if it still runs after
  /// `time`.
  std::optional<int> wait(std::chrono::milliseconds time);

  void signal(int number) const;
  pid_t pid() const { return pid_; }

  /// Returns its output so far.
  std::string output() const;

  /// Returns true once its output has `text`; false if it ends without it or `time` is over.
  bool wait_for_output(const std::string& text, std::chrono::milliseconds time);

 private:
  std::filesystem::path output_;
  pid_t pid_;
  std::optional<int> exit_code_;
};

}  // namespace burnish
