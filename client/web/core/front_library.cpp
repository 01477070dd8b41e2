// Lines about scans, sessions, work and messages: they need no open session.

#include "client/web/core/front_commands.h"
#include "common/base/parse_number.h"

namespace burnish {

namespace {

Result<uint64_t> parse_count(const std::string& word) {
  if (const auto number = parse_number<uint64_t>(word)) return *number;
  return invalid_argument("'" + word + "' is not a number from 0");
}

/// Returns the words from `first` on, with spaces between.
std::string rest_from(const FrontWords& line, size_t first) {
  std::string text;
  for (size_t i = first; i < line.words.size(); ++i)
    text += (text.empty() ? "" : " ") + line.words[i];
  return text;
}

Result<ScanInfo> find_scan(const Workspace& workspace, const std::string& id) {
  for (const ScanInfo& scan : workspace.library().scans)
    if (scan.id == id) return scan;
  return not_found("the server's list has no scan '" + id + "'");
}

Result<SessionInfo> find_session(const Workspace& workspace, const std::string& id) {
  for (const SessionInfo& session : workspace.library().sessions)
    if (session.id == id) return session;
  return not_found("the server's list has no session '" + id + "'");
}

/// Does ID [anew] [depth N].
Status open_scan(const FrontWords& line, Workspace& workspace) {
  ASSIGN_OR_RETURN(const ScanInfo scan, find_scan(workspace, line.words[1]));
  bool is_anew = false;
  int depth = 0;
  for (size_t i = 2; i < line.words.size(); ++i) {
    if (line.words[i] == "anew") {
      is_anew = true;
    } else if (line.words[i] == "depth" && i + 1 < line.words.size()) {
      ASSIGN_OR_RETURN(const uint64_t number, parse_count(line.words[++i]));
      depth = static_cast<int>(std::min<uint64_t>(number, kDepthMax + 1));
    } else {
      return invalid_argument("'" + line.words[i] + "' is neither 'anew' nor 'depth' and a number");
    }
  }
  workspace.open_scan(scan, is_anew ? Opening::kAnew : Opening::kGoOn, depth);
  return Status::ok();
}

Status do_scan(const FrontWords& line, Workspace& workspace) {
  RETURN_IF_ERROR(need_words(line, 2));
  const std::string& what = line.words[0];
  if (what == "open") return open_scan(line, workspace);
  ASSIGN_OR_RETURN(const ScanInfo scan, find_scan(workspace, line.words[1]));
  if (what == "delete") {
    workspace.delete_scan(scan.id);
    return Status::ok();
  }
  if (what != "rename")
    return invalid_argument("'" + what + "' is not open, rename or delete of a scan");
  RETURN_IF_ERROR(need_words(line, 3));
  workspace.rename_scan(scan.id, rest_from(line, 2));
  return Status::ok();
}

Status do_session(const FrontWords& line, Workspace& workspace) {
  RETURN_IF_ERROR(need_words(line, 2));
  const std::string& what = line.words[0];
  ASSIGN_OR_RETURN(const SessionInfo session, find_session(workspace, line.words[1]));
  if (what == "join") {
    workspace.join(session);
  } else if (what == "delete") {
    workspace.delete_session(session);
  } else if (what == "rename") {
    RETURN_IF_ERROR(need_words(line, 3));
    workspace.rename_session(session, rest_from(line, 2));
  } else {
    return invalid_argument("'" + what + "' is not join, rename or delete of a session");
  }
  return Status::ok();
}

Status cancel_activity(const FrontWords& line, FrontParts& parts) {
  RETURN_IF_ERROR(need_words(line, 2));
  ASSIGN_OR_RETURN(const uint64_t number, parse_count(line.words[1]));
  for (const auto& activity : parts.workspace.activities())
    if (parts.state.number_of(activity) == number) activity->cancel();
  return Status::ok();  // it may have ended meanwhile
}

Status dismiss_message(const FrontWords& line, FrontState& state) {
  RETURN_IF_ERROR(need_words(line, 2));
  ASSIGN_OR_RETURN(const uint64_t number, parse_count(line.words[1]));
  state.dismissed.insert(number);
  return Status::ok();
}

}  // namespace

std::optional<Status> do_library_line(const FrontWords& line, FrontParts& parts) {
  if (line.command == "scan") return do_scan(line, parts.workspace);
  if (line.command == "session") return do_session(line, parts.workspace);
  if (line.command == "activity") return cancel_activity(line, parts);
  if (line.command == "message") return dismiss_message(line, parts.state);
  if (line.command != "library") return std::nullopt;
  parts.workspace.refresh_library();
  return Status::ok();
}

}  // namespace burnish
