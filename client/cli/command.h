#pragma once

#include <functional>
#include <string>

#include <CLI/CLI.hpp>

#include "common/base/status.h"

namespace burnish {

/// The subcommands of `burnish`. Exit codes: 0 done, 1 failed (the Status of `run`, printed to
/// standard error), 2 usage (CLI11's parse errors, and usage_error()).
class CommandTable {
 public:
  explicit CommandTable(CLI::App& app) : app_(app) {}

  /// Adds `burnish NAME`. `run` is called after a successful parse if the user chose this command.
  CLI::App* add(const std::string& name, const std::string& description,
                std::function<Status()> run);

  /// Parses, runs and reports. Returns the exit code.
  int run(int argc, char** argv);

 private:
  CLI::App& app_;
  std::function<Status()> chosen_;
};

/// Turns the Status of a check into CLI11's error, so that the program exits with 2. Use it inside
/// option->check(...) or option->each(...) callbacks.
inline std::string usage_message(const Status& status) {
  return status.is_ok() ? std::string() : status.message();
}

}  // namespace burnish
