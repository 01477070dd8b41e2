#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "common/base/status.h"

namespace burnish {

/// A line of a script: a command and what it is told.
struct ScriptLine {
  size_t number = 0;  ///< from 1
  std::string command;
  std::vector<std::string> words;

  /// What follows the command, as one text.
  std::string rest() const;
};

/// Lines as script_help() describes them; '#' begins a comment.
/// Fails: invalid_argument for an unknown command, or one with too few or too many words, naming
/// `name`, line and command.
Result<std::vector<ScriptLine>> parse_script(std::string_view text, const std::string& name);

/// One line for each command.
std::string script_help();

}  // namespace burnish
