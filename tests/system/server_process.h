#pragma once

#include <memory>
#include <string>
#include <vector>

#include "tests/common/temporary_folder.h"
#include "tests/system/process.h"

namespace burnish {

/// How long a step of a system test may take before it counts as hanging.
inline constexpr std::chrono::seconds kPatience{120};

/// A command of `burnish` that has ended.
struct CommandOutcome {
  int exit_code;
  std::string output;
};

/// A burnish-server for a test on a free loopback port, and `burnish` to talk to it.
class ServerProcess {
 public:
  explicit ServerProcess(std::vector<std::string> more_flags = {}) : flags(std::move(more_flags)) {
    start();
  }

  /// Starts on the same data folder, on a new port unless `listen` names one.
  void start(const Process::Limits& limits = {});

  /// Sends SIGKILL and waits for the end.
  void kill();

  /// Sends SIGUSR1 to a server with a library of faults (die_at.cpp, fault_on_signal.cu), and waits
  /// until it is heard: edits that are sent next could be faster.
  void arm_fault();

  /// Runs `burnish WORDS... --server HERE` to its end.
  CommandOutcome burnish(std::vector<std::string> words);

  /// Starts `burnish WORDS... --server HERE`.
  std::unique_ptr<Process> start_burnish(std::vector<std::string> words);

  /// Returns the text after `announcement` on its line of the server's output.
  std::string announced(const std::string& announcement) const;

  /// Returns the command line of the server, to start a second one.
  std::vector<std::string> command_line() const;

  /// Return the number of files and folders below the library's staging/ and scans/.
  size_t staged() const { return entries("staging"); }
  size_t scans() const { return entries("scans"); }

  TemporaryFolder folder;
  std::vector<std::string> flags;  ///< flags of burnish-server besides its address and folder
  std::vector<std::string> client_flags;  ///< flags of burnish besides the address
  std::unique_ptr<Process> process;
  std::string address;
  std::string listen = "127.0.0.1:0";  ///< address for start(); `address` takes the same again

 private:
  size_t entries(const std::string& name) const;
  int outputs_ = 0;
};

/// Writes a generated sphere of 642 (level 3) vertices times four for each further level.
std::string write_sphere(const TemporaryFolder& folder, int level = 3);

}  // namespace burnish
