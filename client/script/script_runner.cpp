#include "client/script/script_runner.h"

#include <cstdio>

#include "client/script/script_edits.h"
#include "client/script/script_view.h"

namespace burnish {

ScriptRunner::ScriptRunner(Workspace& workspace, PageRenderer& renderer, ScriptHost host)
    : workspace_(workspace), renderer_(renderer), host_(std::move(host)) {}

Status ScriptRunner::run(const std::vector<ScriptLine>& script, const std::string& name) {
  for (const ScriptLine& line : script) {
    const Status status = run_line(line);
    if (!status.is_ok())
      return status.with_context(name + ":" + std::to_string(line.number) + ": " + line.command);
  }
  return save_edits().with_context(name);
}

static const char* state_name(const Document& document) {
  if (!document.is_settled()) return "converging";
  return document.stats().frame.exact ? "exact" : "settled";
}

static void print_state(const Document& document) {
  const FrameStats& frame = document.stats().frame;
  std::printf("%s: %s, beta %g, curve %s, %zu entries, %d cycles, distance %.3g, %s, %s, %s\n",
              document.session().name.c_str(), state_name(document), document.beta(),
              document.curve().curve().to_string().c_str(), document.history().size(), frame.cycles,
              frame.distance, text_of(document.controls()).c_str(),
              text_of(document.equaliser()).c_str(), text_of(document.palette()).c_str());
  if (document.edges().is_on()) std::printf("%s\n", text_of(document.edges()).c_str());
  if (document.has_colours()) std::printf("%s\n", text_of(document.colour_filter()).c_str());
  if (document.texture().is_on()) std::printf("%s\n", text_of(document.texture()).c_str());
  if (frame.volume != 0) std::printf("volume %.6g %% of the scan's\n", 100 * frame.volume);
}

Status ScriptRunner::update() {
  workspace_.update();
  RETURN_IF_ERROR(workspace_.look());
  const auto& messages = workspace_.log.messages();
  for (; messages_seen_ < messages.size(); ++messages_seen_) {
    const Message& message = messages[messages_seen_];
    if (message.severity == Severity::kError) return failed_precondition(message.text);
    if (message.severity == Severity::kWarning && host_.warn) host_.warn(message.text);
  }
  return Status::ok();
}

Status ScriptRunner::update_until(const std::function<bool()>& done, const std::string& what,
                                  std::chrono::milliseconds patience) {
  constexpr auto kPictureInterval = std::chrono::milliseconds(10);
  const auto deadline = std::chrono::steady_clock::now() + patience;
  for (;;) {
    RETURN_IF_ERROR(update());
    if (done()) return Status::ok();
    if (std::chrono::steady_clock::now() > deadline)
      return {StatusCode::kDeadlineExceeded, what + " takes too long"};
    host_.wait(kPictureInterval);
  }
}

Status ScriptRunner::update_document_until(const std::function<bool(const Document&)>& done,
                                           const std::string& what) {
  const auto is_over = [&] { return !workspace_.document() || done(*workspace_.document()); };
  RETURN_IF_ERROR(update_until(is_over, what));
  if (workspace_.document()) return Status::ok();
  return failed_precondition("the session was closed while the script waited");
}

Status ScriptRunner::run_line(const ScriptLine& line) {
  const std::string& command = line.command;
  if (command == "open" || command == "join" || command == "close") return run_session(line);
  Document* const document = workspace_.document();
  if (!document) return failed_precondition("no session is open");
  if (command == "wait")
    return update_document_until([](const Document& of) { return of.is_settled(); }, "settling");
  if (command == "export") return run_export(line);
  if (command == "fork") return run_fork(line);
  if (command == "screenshot") return take_screenshot(line.rest());
  if (command == "print") {
    print_state(*document);
    return Status::ok();
  }
  if (command == "drag" || command == "turn") return run_pointer(line);
  if (command == "size") return run_size(line);
  if (is_view_command(command)) return run_view(line);
  RETURN_IF_ERROR(change_document(line, *document));
  return command == "keep_edges" || command == "preset" ? wait_for_noise() : update();
}

Status ScriptRunner::wait_for_noise() {
  return update_document_until([](const Document& of) { return !of.waits_for_noise(); },
                               "measuring the noise");
}

// Waits for acknowledgements: a server that answers acknowledges at once.
Status ScriptRunner::save_edits() {
  const auto is_over = [this] {
    return workspace_.unsaved().edits == 0 || workspace_.link() == LinkState::kEnded;
  };
  const Status saved = update_until(is_over, "saving", host_.saving);
  const Unsaved unsaved{.edits = workspace_.unsaved().edits};
  return unsaved.is_there() ? failed_precondition(text_of(unsaved) + " and will be lost") : saved;
}

Status ScriptRunner::run_session(const ScriptLine& line) {
  RETURN_IF_ERROR(save_edits());
  if (line.command == "close") {
    workspace_.close_document();
    return update();
  }
  workspace_.close_document();
  is_camera_placed_ = false;
  if (line.command == "open") workspace_.import_scan(line.rest(), Opening::kAnew);
  if (line.command == "join") workspace_.join_by_name(line.rest());
  return update_until(
      [this] {
        const Document* const document = workspace_.document();
        return document && document->link() == LinkState::kLive && document->stats().frames > 0;
      },
      "opening");
}

Status ScriptRunner::run_export(const ScriptLine& line) {
  ASSIGN_OR_RETURN(const ExportLine wish, parse_export(line.words));
  const uint64_t before = workspace_.exports_done();
  workspace_.export_mesh(wish.file, wish.is_exact, wish.has_record);
  return update_until([this, before] { return workspace_.exports_done() > before; }, "exporting");
}

// Waits for all detail that the picture can have.
Status ScriptRunner::finish_picture() {
  workspace_.want_picture();
  RETURN_IF_ERROR(update());
  return update_document_until([](const Document& of) { return of.is_picture_settled(); },
                               "drawing");
}

}  // namespace burnish
