#pragma once

#include <filesystem>
#include <optional>

#include "server/config/config.h"

namespace burnish {

struct CommandLine {
  ServerConfig config;
  std::filesystem::path port_file;  ///< empty for none
};

/// Reads the file of --config, then the flags, which override it. Prints help, version and errors
/// itself; then it returns nothing and sets `exit_code`: 0 after help and version, 2 for wrong
/// usage.
std::optional<CommandLine> parse_command_line(int argc, const char* const* argv, int& exit_code);

}  // namespace burnish
