#include "client/web/core/front_commands.h"

#include "client/script/script_edits.h"
#include "client/script/script_view.h"
#include "common/base/text_lines.h"

namespace burnish {

Status need_words(const FrontWords& line, size_t least) {
  if (line.words.size() >= least) return Status::ok();
  return invalid_argument(std::to_string(line.words.size()) + " words after '" + line.command +
                          "'; it needs " + std::to_string(least));
}

// Lines of the script language that wait there, and need not here.
static std::optional<Status> do_script_line(const FrontWords& line, Workspace& workspace) {
  if (line.command == "fork") {
    workspace.fork(line.rest(), "");
    return Status::ok();
  }
  if (line.command == "close") {
    workspace.close_document();
    return Status::ok();
  }
  if (line.command != "export") return std::nullopt;
  const auto wish = parse_export(line.words);
  if (wish.is_ok()) workspace.export_mesh(wish->file, wish->is_exact, wish->has_record);
  return wish.status();
}

static Status do_document_line(const FrontWords& line, FrontParts& parts) {
  if (auto done = do_file_line(line, parts)) return *done;
  if (auto done = do_strength_line(line, parts)) return *done;
  Document* const document = parts.workspace.document();
  if (!document) return failed_precondition("no session is open");
  if (auto done = do_preview(line, *document)) return *done;
  if (auto done = do_panel_line(line, parts.workspace)) return *done;
  if (auto done = do_plot(line, *document)) return *done;
  if (auto done = do_tool_line(line, parts)) return *done;
  if (auto done = do_view_line(line, parts)) return *done;
  // The rest is of the script language, which checks the number of words.
  std::string text = line.command + " " + line.rest();
  ASSIGN_OR_RETURN(const auto script, parse_script(text, "page"));
  const ScriptLine& one = script.front();
  if (auto done = do_script_line(one, parts.workspace)) return *done;
  if (is_view_command(one.command)) return change_view(one, parts.workspace);
  return change_document(one, *document);
}

Status do_front_line(const std::string& line, FrontParts& parts) {
  const std::vector<TextLine> lines = split_lines(line);
  if (lines.size() != 1) return invalid_argument("a line of the page must be one line");
  FrontWords words{1, std::string(lines[0].words[0]), {}};
  words.words.assign(lines[0].words.begin() + 1, lines[0].words.end());
  if (auto done = do_library_line(words, parts)) return *done;
  return do_document_line(words, parts);
}

}  // namespace burnish
