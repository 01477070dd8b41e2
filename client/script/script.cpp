#include "client/script/script.h"

#include <algorithm>

#include "common/base/text_lines.h"
#include "common/edit/edit_lines.h"

namespace burnish {
namespace {

// Beside the commands that are edits.
constexpr CommandForm kOtherCommands[] = {
    {"open", 1, kAnyWords, "open FILE: imports a mesh file and opens it"},
    {"join", 1, kAnyWords, "join SESSION: joins a session by name or id"},
    {"close", 0, 0, "close: goes back to the start page"},
    {"fidelity", 1, 1, "fidelity ALPHA: moves the whole curve to this alpha"},
    {"preset", 1, kAnyWords,
     "preset NAME [STRENGTH]: one of the window's presets, from 0 to 1 of it"},
    {"keep_edges", 1, 1,
     "keep_edges auto|off|machined|scanner|soft|relief: noise goes, edges stay, at a fidelity for "
     "both; auto asks the scan's own noise"},
    {"brush", 3, 6,
     "brush RADIUS STRENGTH BETA [smooth|linear|sharp|constant [WHAT] [through]]: of drag"},
    {"drag", 2, kAnyWords, "drag X Y [X Y]...: paints with the pointer, in pixels of the picture"},
    {"turn", 4, kAnyWords, "turn X Y X Y...: drags the camera in the same way"},
    {"fork", 0, kAnyWords, "fork [NAME]: opens a copy of the session; the server names it"},
    {"wait", 0, 0, "wait: waits until all edits are applied and the surface settles"},
    {"camera", 2, 6, "camera AZIMUTH ELEVATION [DISTANCE [X Y Z]]: without target, frames all"},
    {"frame", 0, 1, "frame [FARTHER]: shows the whole scan, from FARTHER times the distance"},
    {"colour", 1, 1, "colour clay|beta|curvature|displacement|scan"},
    {"flat", 1, 1, "flat on|off"},
    {"wireframe", 1, 1, "wireframe on|off"},
    {"split", 1, 1, "split on|off"},
    {"original", 1, 1, "original on|off"},
    {"up", 1, 1, "up x|y|z|-x|-y|-z: the axis that points up"},
    {"view", 1, 1, "view front|back|right|left|top|bottom: shows the whole scan from there"},
    {"orthographic", 1, 1, "orthographic on|off: draws without perspective"},
    {"scale_bar", 1, 1, "scale_bar on|off: a bar of a round length in pictures; off at first"},
    {"light", 1, 1, "light clay|radiance|cavity|raking|ceramic|bronze|slopes|unlit"},
    {"light_direction", 2, 2, "light_direction AZIMUTH ELEVATION: of the lamp, in degrees"},
    {"specular", 1, 1, "specular STRENGTH: of the lamp's highlight"},
    {"occlusion", 1, 1, "occlusion STRENGTH: how dark hollows are"},
    {"radiance", 1, 1, "radiance STRENGTH: of light radiance"},
    {"cavity", 2, 2, "cavity RIDGE VALLEY: strengths of light cavity"},
    {"mirror", 1, 2, "mirror off|x|y|z [AT]: paints strokes on both sides of a plane"},
    {"size", 1, 1, "size WIDTHxHEIGHT: sets the picture's size, in pixels"},
    {"screenshot", 1, kAnyWords, "screenshot FILE: writes the picture as PNG"},
    {"export", 1, 3, "export FILE [exact] [record]: writes the edited mesh, and who did what"},
    {"print", 0, 0, "print: prints the state on standard output"},
};

std::vector<CommandForm> commands() {
  std::vector<CommandForm> all(std::begin(kOtherCommands), std::end(kOtherCommands));
  const std::vector<CommandForm> edits = edit_commands();
  all.insert(all.end(), edits.begin(), edits.end());
  return all;
}

}  // namespace

Result<std::vector<ScriptLine>> parse_script(std::string_view text, const std::string& name) {
  const std::vector<CommandForm> forms = commands();
  std::vector<ScriptLine> script;
  for (const TextLine& line : split_lines(text)) {
    const std::string command(line.words[0]);
    const auto form = std::ranges::find(forms, command, &CommandForm::name);
    if (form == forms.end())
      return invalid_argument(place(name, line) + ": unknown command '" + command + "'");
    RETURN_IF_ERROR(check_words(*form, line.words.size() - 1).with_context(place(name, line)));
    script.push_back({line.number, command, {line.words.begin() + 1, line.words.end()}});
  }
  return script;
}

std::string script_help() {
  std::string help;
  for (const CommandForm& form : commands()) help += "  " + std::string(form.help) + "\n";
  return help;
}

}  // namespace burnish
