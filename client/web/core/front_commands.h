#pragma once

#include <string>

#include "client/model/workspace/workspace.h"
#include "client/script/script.h"
#include "client/web/core/front.h"
#include "client/web/core/front_state.h"

namespace burnish {

/// The objects that a line of the page works on.
struct FrontParts {
  Workspace& workspace;
  FrontState& state;
  const FrontHost& host;
};

/// Does a line of the script language or of `frontCommands` (client/web/page/src/commands.ts).
/// Waits for nothing. Fails: invalid_argument that names the word; failed_precondition without the
/// session that the line needs; not_found.
Status do_front_line(const std::string& line, FrontParts& parts);

/// A line's command and words.
using FrontWords = ScriptLine;

// By subject; each returns nothing for a command of another one.
std::optional<Status> do_library_line(const FrontWords& line, FrontParts& parts);
std::optional<Status> do_preview(const FrontWords& line, Document& document);
std::optional<Status> do_panel_line(const FrontWords& line, Workspace& workspace);
std::optional<Status> do_plot(const FrontWords& line, Document& document);
std::optional<Status> do_strength_line(const FrontWords& line, FrontParts& parts);
std::optional<Status> do_tool_line(const FrontWords& line, FrontParts& parts);
std::optional<Status> do_view_line(const FrontWords& line, FrontParts& parts);
std::optional<Status> do_file_line(const FrontWords& line, FrontParts& parts);

/// Fails: invalid_argument for fewer words than `least`, counted behind the command.
Status need_words(const FrontWords& line, size_t least);

}  // namespace burnish
