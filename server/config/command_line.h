#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "server/config/config.h"

namespace burnish {

/// The task of `burnish-server journal copy FROM TO`. Each is a data folder or the URI of a
/// database.
struct JournalCopyWish {
  std::string from, to;
};

struct CommandLine {
  ServerConfig config;
  std::filesystem::path port_file;      ///< empty for none
  bool ends_with_input = false;         ///< the server ends when its standard input does
  std::optional<JournalCopyWish> copy;  ///< then nothing is served
};

/// Reads the file of --config, then the flags, which override it. Prints help, version, the
/// configuration of --print-config and errors itself; then it returns nothing and sets `exit_code`:
/// 0 after these, 2 for wrong usage.
std::optional<CommandLine> parse_command_line(int argc, const char* const* argv, int& exit_code);

}  // namespace burnish
