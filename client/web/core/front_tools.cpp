// Lines about what the pointer does, and about the session.

#include "client/model/view/section_view.h"
#include "client/report/section_file.h"
#include "client/tools/band_choice.h"
#include "client/tools/own_presets.h"
#include "client/web/core/front_commands.h"
#include "common/base/text_lines.h"

namespace burnish {

namespace {

Result<SessionRole> parse_role(const std::string& word) {
  for (const SessionRole role : {SessionRole::kViewer, SessionRole::kEditor, SessionRole::kOwner})
    if (word == session_role_name(role)) return role;
  return invalid_argument("'" + word + "' is not viewer, editor or owner");
}

/// Does USER ROLE. The name may have several words.
Status set_role(const FrontWords& line, Document& document) {
  RETURN_IF_ERROR(need_words(line, 2));
  ASSIGN_OR_RETURN(const SessionRole role, parse_role(line.words.back()));
  FrontWords user = line;
  user.words.pop_back();
  document.set_role(user.rest(), role);
  return Status::ok();
}

Status set_tool(const FrontWords& line, Viewport& viewport) {
  RETURN_IF_ERROR(need_words(line, 1));
  const std::string& tool = line.words[0];
  if (tool != "paint" && tool != "look" && tool != "measure")
    return invalid_argument("'" + tool + "' is not paint, look or measure");
  viewport.navigate_mode = tool == "look";
  viewport.measure_mode = tool == "measure";
  return Status::ok();
}

// The pointer's next moves set the value, and a click ends that.
Status drag_brush(const FrontWords& line, Workspace& workspace) {
  RETURN_IF_ERROR(need_words(line, 1));
  const std::string& what = line.words[0];
  if (what != "radius" && what != "strength")
    return invalid_argument("'" + what + "' is neither radius nor strength");
  const Document& document = *workspace.document();
  what == "radius" ? workspace.viewport.begin_radius(document)
                   : workspace.viewport.begin_strength(document);
  return Status::ok();
}

Status cut_section(const FrontParts& parts) {
  Measuring& measuring = parts.workspace.document()->measuring();
  if (measuring.ruler.ends().size() < 2)
    return failed_precondition("a section needs a ruler with two points");
  measuring.cut(section_plane(measuring.ruler, parts.workspace.viewport.camera));
  return Status::ok();
}

Status save_section(const std::string& ending, const FrontParts& parts) {
  const Document& document = *parts.workspace.document();
  const auto& section = document.measuring().section();
  if (!section) return failed_precondition("there is no section yet");
  const std::string name = document.scan().scan.name + "-section." + ending;
  RETURN_IF_ERROR(check_section_name(name));
  parts.host.download(
      name, ending == "svg" ? section_svg(*section, document.unit()) : section_csv(*section));
  return Status::ok();
}

Status exaggerate_section(const FrontWords& line, const FrontParts& parts) {
  constexpr double kMost = 50;
  RETURN_IF_ERROR(need_words(line, 2));
  ASSIGN_OR_RETURN(const double times, parse_real(line.words[1]));
  if (!(times >= 1 && times <= kMost))
    return invalid_argument("section heights " + line.words[1] + " is outside 1 to 50");
  parts.state.section_exaggeration = times;
  return Status::ok();
}

/// Does cut, close, heights and a number, or save and svg or csv.
Status do_section(const FrontWords& line, const FrontParts& parts) {
  RETURN_IF_ERROR(need_words(line, 1));
  const std::string& what = line.words[0];
  if (what == "cut") return cut_section(parts);
  if (what == "heights") return exaggerate_section(line, parts);
  if (what == "save") {
    RETURN_IF_ERROR(need_words(line, 2));
    return save_section(line.words[1], parts);
  }
  if (what != "close") return invalid_argument("'" + what + "' is not cut, close, heights or save");
  parts.workspace.document()->measuring().forget_section();
  return Status::ok();
}

Status open_at(const FrontWords& line, Workspace& workspace) {
  RETURN_IF_ERROR(need_words(line, 1));
  ASSIGN_OR_RETURN(const int depth, parse_integer(line.words[0]));
  workspace.open_again(depth);
  return Status::ok();
}

/// Keeps the gradient scale, the curve and the bands.
Status keep_preset(const FrontWords& line, const Document& document) {
  RETURN_IF_ERROR(need_words(line, 1));
  return save_own_preset(own_presets_path(),
                         own_preset(line.rest(), document.filter(), document.lengths()));
}

Status open_strip(StrengthStrip& strip, Document& document) {
  const auto own = read_own_presets(own_presets_path());
  const auto shown = document.preset_in_force(own.is_ok() ? *own : std::vector<Preset>());
  return shown ? strip.open(*shown, document) : failed_precondition("no preset is in force");
}

Status choose_strength(const FrontWords& line, StrengthStrip& strip, Document& document) {
  RETURN_IF_ERROR(need_words(line, 2));
  ASSIGN_OR_RETURN(const int number, parse_integer(line.words[1]));
  return strip.choose(number, document);
}

}  // namespace

std::optional<Status> do_strength_line(const FrontWords& line, FrontParts& parts) {
  if (line.command != "strengths") return std::nullopt;
  const Status has_words = need_words(line, 1);
  if (!has_words.is_ok()) return has_words;
  const std::string& what = line.words[0];
  StrengthStrip& strip = parts.workspace.strip;
  Document* const document = parts.workspace.document();
  if (what == "close") {  // the pictures may have gone with their session
    strip.close(document);
    return Status::ok();
  }
  if (!document) return failed_precondition("no session is open");
  if (what == "open") return open_strip(strip, *document);
  if (what == "choose") return choose_strength(line, strip, *document);
  return invalid_argument("'" + what + "' is not open, close or choose");
}

std::optional<Status> do_tool_line(const FrontWords& line, FrontParts& parts) {
  Workspace& workspace = parts.workspace;
  Document& document = *workspace.document();
  const std::string& command = line.command;
  if (command == "role") return set_role(line, document);
  if (command == "tool") return set_tool(line, workspace.viewport);
  if (command == "brush_drag") return drag_brush(line, workspace);
  if (command == "section") return do_section(line, parts);
  if (command == "depth") return open_at(line, workspace);
  if (command == "preset_keep") return keep_preset(line, document);
  if (command == "preset_delete") return delete_own_preset(own_presets_path(), line.rest());
  if (command == "ruler") {
    document.measuring().ruler.clear();
  } else if (command == "unit") {
    document.name_unit(line.rest());
  } else if (command == "cancel") {
    workspace.viewport.cancel(document);
  } else if (command == "bands" && line.words == std::vector<std::string>{"first"}) {
    document.commit(SetEqualiser{first_bands(document.cell_size(), document.diagonal())});
  } else {
    return std::nullopt;
  }
  return Status::ok();
}

}  // namespace burnish
