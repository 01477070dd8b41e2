#include "client/script/script.h"

#include <algorithm>

#include "common/base/text_lines.h"

namespace burnish {
namespace {

struct CommandForm {
  std::string_view name;
  size_t words_min;
  size_t words_max;
  std::string_view help;
};

constexpr size_t kAny = 100'000;

constexpr CommandForm kForms[] = {
    {"open", 1, kAny, "open FILE: imports a mesh file and opens it"},
    {"join", 1, kAny, "join SESSION: joins a session by name or id"},
    {"close", 0, 0, "close: goes back to the start page"},
    {"beta", 1, 1, "beta VALUE: the gradient scale"},
    {"fidelity", 1, 1, "fidelity ALPHA: moves the whole curve to this alpha"},
    {"curve", 1, 1, "curve K:A,K:A,...: the transfer curve"},
    {"preset", 1, kAny, "preset NAME [STRENGTH]: one of the window's presets, from 0 to 1 of it"},
    {"controls", 3, 3, "controls PIN CAP KEEP: rims on|off, largest move or 0, volume on|off"},
    {"protect", 1, kAny, "protect WORDS: a region in which nothing moves (burnish protect --help)"},
    {"bands", 0, 6, "bands [SIZE:GAIN]...: gains of details up to these sizes; none removes them"},
    {"keep_edges", 1, 1,
     "keep_edges auto|machined|scanner|soft|relief: noise goes, edges stay, at a fidelity for "
     "both; "
     "auto asks the scan's own noise"},
    {"edges", 1, 5, "edges bilateral|edges STRENGTH ANGLE PASSES CRISPNESS, or edges off"},
    {"palette", 0, kAny, "palette [CURVE RRGGBB NAME [; ...]]: the curves that a brush can paint"},
    {"colours", 1, 2, "colours BETA [ALPHA]: filters the scan's colours"},
    {"brush", 3, 6,
     "brush RADIUS STRENGTH BETA [smooth|linear|sharp|constant [WHAT] [through]]: of drag"},
    {"drag", 2, kAny, "drag X Y [X Y]...: paints with the pointer, in pixels of the picture"},
    {"turn", 4, kAny, "turn X Y X Y...: drags the camera in the same way"},
    {"stroke", 7, kAny,
     "stroke RADIUS STRENGTH BETA FALLOFF [WHAT] [through] X Y Z...: paints along points; through "
     "thin walls too"},
    {"undo", 0, 0, "undo: takes back your last edit"},
    {"redo", 0, 0, "redo: brings back what undo took back"},
    {"switch", 2, 2, "switch NUMBER on|off: switches an entry of the history"},
    {"checkpoint", 1, kAny, "checkpoint NAME"},
    {"restore", 1, kAny, "restore NAME: goes back to a checkpoint"},
    {"fork", 1, kAny, "fork NAME: opens a copy of the session"},
    {"wait", 0, 0, "wait: waits until all edits are applied and the surface settles"},
    {"camera", 2, 6, "camera AZIMUTH ELEVATION [DISTANCE X Y Z]: without target, frames all"},
    {"frame", 0, 1, "frame [FARTHER]: shows the whole scan, from FARTHER times the distance"},
    {"colour", 1, 1, "colour clay|beta|curvature|displacement|scan"},
    {"flat", 1, 1, "flat on|off"},
    {"wireframe", 1, 1, "wireframe on|off"},
    {"split", 1, 1, "split on|off"},
    {"original", 1, 1, "original on|off"},
    {"up", 1, 1, "up x|y|z|-x|-y|-z: the axis that points up"},
    {"view", 1, 1, "view front|back|right|left|top|bottom: shows the whole scan from there"},
    {"orthographic", 1, 1, "orthographic on|off: draws without perspective"},
    {"light", 1, 1, "light clay|radiance|cavity|raking|ceramic|bronze|slopes"},
    {"light_direction", 2, 2, "light_direction AZIMUTH ELEVATION: of the lamp, in degrees"},
    {"specular", 1, 1, "specular STRENGTH: of the lamp's highlight"},
    {"occlusion", 1, 1, "occlusion STRENGTH: how dark hollows are"},
    {"radiance", 1, 1, "radiance STRENGTH: of light radiance"},
    {"cavity", 2, 2, "cavity RIDGE VALLEY: strengths of light cavity"},
    {"mirror", 1, 2, "mirror off|x|y|z [AT]: paints strokes on both sides of a plane"},
    {"size", 1, 1, "size WIDTHxHEIGHT: sets the picture's size, in pixels"},
    {"screenshot", 1, kAny, "screenshot FILE: writes the picture as PNG"},
    {"export", 1, 3, "export FILE [exact] [record]: writes the edited mesh, and who did what"},
    {"print", 0, 0, "print: prints the state on standard output"},
};

}  // namespace

std::string ScriptLine::rest() const {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

Result<std::vector<ScriptLine>> parse_script(std::string_view text, const std::string& name) {
  std::vector<ScriptLine> script;
  for (const TextLine& line : split_lines(text)) {
    const std::string command(line.words[0]);
    const auto form = std::find_if(std::begin(kForms), std::end(kForms),
                                   [&](const CommandForm& each) { return each.name == command; });
    if (form == std::end(kForms))
      return invalid_argument(place(name, line) + ": unknown command '" + command + "'");
    const size_t words = line.words.size() - 1;
    if (words < form->words_min || words > form->words_max)
      return invalid_argument(place(name, line) + ": " + std::to_string(words) + " words after '" +
                              command + "'; write " + std::string(form->help));
    script.push_back({line.number, command, {line.words.begin() + 1, line.words.end()}});
  }
  return script;
}

std::string script_help() {
  std::string help;
  for (const CommandForm& form : kForms) help += "  " + std::string(form.help) + "\n";
  return help;
}

}  // namespace burnish
