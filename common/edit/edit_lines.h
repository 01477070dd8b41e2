#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/edit/edit.h"

namespace burnish {

/// A command of a script, and how many words it takes.
struct CommandForm {
  std::string_view name;
  size_t words_min = 0;
  size_t words_max = 0;
  std::string_view help;  ///< "beta VALUE: the gradient scale"
};

inline constexpr size_t kAnyWords = 100'000;

/// Fails: invalid_argument that names both counts' command and its help.
Status check_words(const CommandForm& form, size_t words);

/// Returns the commands that are edits, in the order of EditKind.
std::vector<CommandForm> edit_commands();

/// Returns the kind of edit that a command is; nothing for another command.
std::optional<EditKind> edit_kind_of(std::string_view command);

/// Parses the words behind a command that is an edit. Values that they leave out stay as `now`.
/// Fails: as check_words() and validate() do; invalid_argument that names the word.
Result<Change> parse_edit(std::string_view command, const std::vector<std::string>& words,
                          const Settings& now);

/// Parses a whole line that is an edit fields are made of: "colours 0.5". Fails: as parse_edit()
/// does; invalid_argument for another command.
Result<Change> parse_edit_line(std::string_view line, const Settings& now);

/// Returns the line that parses back to the same edit: "beta 0.5". Empty for an edit that no script
/// can say.
std::string line_of(const Change& change);

/// Parses RADIUS STRENGTH BETA [FALLOFF [WHAT] [through]]. Fails: invalid_argument that names the
/// value and its limit.
Result<Brush> parse_brush(const std::vector<std::string>& words);

}  // namespace burnish
