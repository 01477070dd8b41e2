#include <algorithm>
#include <utility>
#include <vector>

#include "client/panels/panels.h"
#include "client/tools/band_choice.h"

namespace burnish {
namespace {

/// Undo may have taken the band or the curve away, and another scan has no colours.
void forget_missing(const Document& document, Brush& brush) {
  if (brush.band > static_cast<int>(document.equaliser().bands.size())) brush.band = 0;
  if (brush.curve > static_cast<int>(document.palette().curves.size())) brush.curve = 0;
  brush.colour &= document.has_colours();
  brush.texture &= document.has_colours();
}

void show_modes(Brush& brush, Widgets& widgets) {
  struct Mode {
    const char* name;
    double value;
  };
  static constexpr Mode kBeta[] = {{"Smooth", 0}, {"Restore", 1}, {"Sharpen", 2}};
  static constexpr Mode kEdges[] = {{"Keep here", 0}, {"Denoise here", 1}};
  static constexpr Mode kTexture[] = {{"Fade", 0}, {"Restore", 1}, {"Strengthen", 2}};
  std::span<const Mode> modes = kBeta;
  if (brush.edges) modes = kEdges;
  if (brush.texture) modes = kTexture;
  const double shown = brush.beta;
  widgets.begin_row(static_cast<int>(modes.size()));
  for (const Mode& mode : modes)
    if (widgets.button(mode.name, "", shown == mode.value ? Pressed::kYes : Pressed::kNo))
      brush.beta = mode.value;
  widgets.end_row();
}

void choose_painted(Workspace& workspace, const Brush& brush, Widgets& widgets) {
  const Document& document = *workspace.document();
  std::vector<Option> options = {{"beta", "Gradient scale β"}, {"edges", "Strength of kept edges"}};
  if (document.has_colours()) options.push_back({"colour", "Gradient scale of colours"});
  if (document.has_colours()) options.push_back({"texture", "Texture gain"});
  const size_t bands = document.equaliser().bands.size();
  const std::vector<PaletteCurve>& curves = document.palette().curves;
  std::vector<std::string> texts;
  texts.reserve(2 * (bands + curves.size()));  // options point at them
  const auto add = [&](const char* kind, size_t number, std::string label) {
    texts.push_back(kind + std::to_string(number));
    texts.push_back(std::move(label));
    options.push_back({texts.end()[-2].c_str(), texts.back().c_str()});
  };
  for (size_t band = 1; band <= bands; ++band)
    add("band:", band, "Gain of " + details_of(document.equaliser(), band));
  for (size_t curve = 1; curve <= curves.size(); ++curve)
    add("curve:", curve, "Curve " + curves[curve - 1].name);
  const std::string painted = painted_word(brush);
  const auto shown = std::ranges::find(options, painted, &Option::word);
  const int taken =
      widgets.choice({.name = "Paints", .options = options, .is_labelled = true},
                     shown == options.end() ? -1 : static_cast<int>(shown - options.begin()));
  if (taken >= 0) paint_instead(options[static_cast<size_t>(taken)].word, workspace);
}

void show_painted_value(Brush& brush, Widgets& widgets) {
  if (brush.curve > 0) return;
  const auto scale = brush.has_own_limits() ? SliderScale::kLinear : SliderScale::kBeta;
  struct Painted {
    const char* name;
    const char* hint;
  };
  const Painted painted =
      brush.edges
          ? Painted{"Painted strength", "How much noise goes under the brush: 0 none, 1 all of it."}
      : brush.band || brush.texture
          ? Painted{"Painted gain",
                    "What stays of these details under the brush: 0 nothing, 1 all, more makes "
                    "them "
                    "stronger."}
          : Painted{"Painted β",
                    "What the brush does to details: on the left it smooths, in the middle it "
                    "restores the scan, on the right it sharpens. β is the gradient scale there."};
  widgets.slider({painted.name, painted.hint, 0, brush.value_max(), scale}, brush.beta);
}

void show_shape(double diagonal, Brush& brush, Widgets& widgets) {
  widgets.slider({.name = "Radius",
                  .hint = "How far the brush reaches from the point under the pointer. [ and ] "
                          "change it, F by a move of the mouse.",
                  .low = 1e-4 * diagonal,
                  .high = 0.5 * diagonal,
                  .scale = SliderScale::kLogarithmic,
                  .note = "in the scan's units"},
                 brush.radius);
  widgets.slider({.name = "Strength",
                  .hint = "How much of it one touch does: 1 all at once; with less, strokes over "
                          "each other add up. Shift+F changes it by a move of the mouse.",
                  .low = 0.01,
                  .high = 1,
                  .digits = 0},
                 brush.strength);
}

void choose_fall_off(Brush& brush, Widgets& widgets) {
  static constexpr Option kFallOffs[] = {{"smooth", "Smooth"},
                                         {"linear", "Linear"},
                                         {"sharp", "Sharp"},
                                         {"constant", "Constant"}};  // as FallOff
  const int taken = widgets.choice({.name = "Fall-off", .options = kFallOffs, .is_labelled = true},
                                   int(brush.fall_off));
  if (taken >= 0) brush.fall_off = static_cast<FallOff>(taken);
}

void show_mirror(Document& document, Widgets& widgets) {
  static constexpr Option kMirrors[] = {
      {"off", "Off"}, {"x", "Across x"}, {"y", "Across y"}, {"z", "Across z"}};
  std::optional<MirrorPlane>& mirror = document.mirror;
  const int taken =
      widgets.choice({.name = "Mirror",
                      .options = kMirrors,
                      .hint = "Paints each stroke on both sides of a plane, as one step.",
                      .is_labelled = true},
                     mirror ? mirror->axis + 1 : 0);
  if (taken == 0) mirror.reset();
  if (taken > 0) mirror = MirrorPlane{taken - 1, document.box().center()[taken - 1]};
  if (!mirror) return;
  widgets.slider({.name = "Mirror plane",
                  .hint = "",
                  .low = document.box().min()[mirror->axis],
                  .high = document.box().max()[mirror->axis],
                  .digits = 4,
                  .has_title = false},
                 mirror->at);
}

}  // namespace

// A strength of kept edges and a texture gain are no β: the brush's β waits among the preferences.
void paint_instead(const char* word, Workspace& workspace) {
  constexpr double kFirstTextureGain = 2;
  Brush& brush = workspace.document()->brush().brush;
  double& beta = workspace.preferences.brush_beta;
  if (word == painted_word(brush)) return;
  const bool painted_beta = !brush.has_own_limits();
  if (painted_beta) beta = brush.beta;
  (void)parse_painted(word, brush);  // it is a word of ours
  if (brush.edges) brush.beta = brush.value_max();
  if (brush.texture) brush.beta = kFirstTextureGain;
  if (!painted_beta && !brush.has_own_limits()) brush.beta = beta;
}

void show_brush(Workspace& workspace, Widgets& widgets) {
  Document& document = *workspace.document();
  Brush& brush = document.brush().brush;
  const bool may_edit = !document.is_viewer();
  forget_missing(document, brush);
  widgets.enable(may_edit && brush.curve == 0);
  show_modes(brush, widgets);
  widgets.enable(may_edit);
  choose_painted(workspace, brush, widgets);
  show_painted_value(brush, widgets);
  show_shape(document.diagonal(), brush, widgets);
  if (workspace.has_pen)
    widgets.check("Pen pressure",
                  "The harder the pen presses, the stronger the brush. Full pressure has the "
                  "strength above.",
                  workspace.preferences.pen_pressure);
  choose_fall_off(brush, widgets);
  bool through = !brush.connected;
  if (widgets.check("Through walls",
                    "Paints all surface in the ball, the other side of a thin wall too. Without "
                    "it the brush paints what hangs together with the place under the pointer.",
                    through))
    brush.connected = !through;
  show_mirror(document, widgets);
}

}  // namespace burnish
