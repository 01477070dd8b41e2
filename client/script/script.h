#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "common/base/status.h"
#include "common/base/text_lines.h"

namespace burnish {

/// A line of a script: a command and its words.
struct ScriptLine {
  size_t number = 0;  ///< from 1
  std::string command;
  std::vector<std::string> words;

  /// Returns the text after the command.
  std::string rest() const { return joined(words); }
};

/// Parses the lines that script_help() describes; '#' begins a comment.
/// Fails: invalid_argument for an unknown command, or too few or too many words. The message names
/// `name`, line and command.
Result<std::vector<ScriptLine>> parse_script(std::string_view text, const std::string& name);

/// Returns one line of help for each command.
std::string script_help();

}  // namespace burnish
