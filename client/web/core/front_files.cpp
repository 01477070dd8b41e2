// Lines whose outcome is a file for the user, and those that say what pictures and snapshots have.
// The last ones need no session.

#include <chrono>
#include <utility>

#include "client/web/core/front_commands.h"
#include "client/web/core/stored_png.h"
#include "common/base/text_lines.h"

namespace burnish {

namespace {

/// Returns the name of a script that begins now.
std::string script_name(const Workspace& workspace) {
  const Document* const document = workspace.document();
  return (document ? document->session().name : "burnish") + ".script";
}

// The script goes on where this session is, or with the next one that opens.
Status do_record(const FrontWords& line, FrontParts& parts) {
  RETURN_IF_ERROR(need_words(line, 1));
  Recorder& recorder = parts.workspace.recorder;
  if (line.words[0] == "start") {
    parts.state.script.emplace(Script{script_name(parts.workspace), ""});
    recorder.open([&script = parts.state.script](const std::string& text) {
      if (script) script->lines += text + "\n";
    });
    if (!parts.workspace.document()) return Status::ok();
    recorder.record("join " + parts.workspace.document()->session().name);
    recorder.record(parts.workspace.viewport.camera);
    return Status::ok();
  }
  if (line.words[0] != "stop")
    return invalid_argument("'" + line.words[0] + "' is neither start nor stop");
  recorder.close();
  if (const auto script = std::exchange(parts.state.script, std::nullopt))
    parts.host.download(script->name, script->lines);
  return Status::ok();
}

/// Draws once more after a failure: WebGL may have told of an earlier picture's.
Status draw_to_save(Workspace& workspace) {
  const Status drawn = workspace.draw();
  return drawn.is_ok() ? drawn : workspace.draw();
}

Status save_picture(const FrontParts& parts, const std::string& name) {
  RETURN_IF_ERROR(parts.workspace.check_picture());
  RETURN_IF_ERROR(draw_to_save(parts.workspace));
  ASSIGN_OR_RETURN(const Image image,
                   parts.workspace.read_picture(parts.workspace.viewport.scale_bar()));
  parts.workspace.record_picture(name);
  parts.host.download(name, stored_png(image));
  if (!image.note.empty()) parts.workspace.log.warning("saved " + name + ": " + image.note);
  return Status::ok();
}

/// Waits until no trial is shown, and for all detail that the picture can have, as long as its
/// session and its camera stay.
void finish_picture(Workspace& workspace, const FrontHost& host) {
  static constexpr std::chrono::milliseconds kLook{20};
  static constexpr std::chrono::seconds kPatience{10};
  const auto end = std::chrono::steady_clock::now() + kPatience;
  const uint64_t begun = workspace.pictures_begun();
  const Camera camera = workspace.viewport.camera;
  const auto waits = [&] {
    const Document* const document = workspace.document();
    if (!document || workspace.pictures_begun() != begun) return false;
    if (std::chrono::steady_clock::now() >= end) return false;
    const bool is_still = workspace.viewport.camera == camera;
    return document->may_show_trial() || (is_still && !document->is_picture_settled());
  };
  do {
    workspace.want_picture();
    host.wait(kLook);
  } while (waits());
}

Status take_picture(const FrontWords& line, FrontParts& parts) {
  RETURN_IF_ERROR(need_words(line, 1));
  std::string name = line.rest();
  if (!name.ends_with(".png")) name += ".png";
  parts.workspace.want_picture();
  RETURN_IF_ERROR(parts.workspace.look());
  if (parts.workspace.document()->is_picture_settled()) return save_picture(parts, name);
  parts.host.begin([parts, name] {
    finish_picture(parts.workspace, parts.host);
    if (!parts.workspace.document()) return;
    const Status saved = save_picture(parts, name);
    if (!saved.is_ok()) parts.workspace.log.failure("picture", saved);
  });
  return Status::ok();
}

Status set_figures(const FrontWords& line, FrontState& state) {
  RETURN_IF_ERROR(need_words(line, 1));
  ASSIGN_OR_RETURN(state.shows_figures, parse_switch(line.words[0]));
  return Status::ok();
}

Status set_over(const FrontWords& line, FrontState& state) {
  RETURN_IF_ERROR(need_words(line, 2));
  ASSIGN_OR_RETURN(const bool is_on, parse_switch(line.words[1]));
  if (line.words[0] == "protection") {
    state.shows_protection = is_on;
  } else if (line.words[0] == "curves") {
    state.shows_curves = is_on;
  } else {
    return invalid_argument("'" + line.words[0] + "' is neither protection nor curves");
  }
  return Status::ok();
}

}  // namespace

std::optional<Status> do_file_line(const FrontWords& line, FrontParts& parts) {
  if (line.command == "picture" && !parts.workspace.document())
    return failed_precondition("no session is open");
  if (line.command == "record") return do_record(line, parts);
  if (line.command == "picture") return take_picture(line, parts);
  if (line.command == "over") return set_over(line, parts.state);
  if (line.command == "figures") return set_figures(line, parts.state);
  return std::nullopt;
}

}  // namespace burnish
