#include <imgui.h>
#include <span>

#include "client/app/panels/panels.h"
#include "client/app/widgets/places.h"
#include "client/app/widgets/theme.h"
#include "client/app/widgets/value_slider.h"
#include "client/tools/band_choice.h"
#include "client/tools/colours.h"

namespace burnish {

// ---- What the brush paints ----

namespace {

constexpr const char* kKeptEdges = "Strength of kept edges";
constexpr const char* kTextureGain = "Texture gain";
constexpr double kFirstTextureGain = 2;

std::string band_label(const Document& document, int band) {
  return "Gain of " + details_of(document.equaliser(), static_cast<size_t>(band));
}

std::string curve_label(const Document& document, int curve) {
  return "Curve " + document.palette().curves[static_cast<size_t>(curve) - 1].name;
}

/// Undo may have taken the band or the curve away.
void forget_missing(const Document& document, Brush& brush) {
  if (brush.band > static_cast<int>(document.equaliser().bands.size())) brush.band = 0;
  if (brush.curve > static_cast<int>(document.palette().curves.size())) brush.curve = 0;
}

// A strength of kept edges and a texture gain are no β: the brush's β waits among the preferences.
void paint_instead(const std::string& word, Brush& brush, Preferences& preferences) {
  if (word == painted_word(brush)) return;
  const bool painted_beta = !brush.has_own_limits();
  if (painted_beta) preferences.brush_beta = brush.beta;
  (void)parse_painted(word, brush);  // it is a word of ours
  if (brush.edges) brush.beta = brush.value_max();
  if (brush.texture) brush.beta = kFirstTextureGain;
  if (!painted_beta && !brush.has_own_limits()) brush.beta = preferences.brush_beta;
}

std::string painted_label(const Document& document, const Brush& brush) {
  if (brush.band > 0) return band_label(document, brush.band);
  if (brush.curve > 0) return curve_label(document, brush.curve);
  if (brush.edges) return kKeptEdges;
  if (brush.texture) return kTextureGain;
  return brush.colour ? "Gradient scale of colours" : "Gradient scale β";
}

}  // namespace

// Draws the list of what the brush can paint: β, the strength of kept edges, the colours and their
// texture gain, the gain of a band, a curve of the palette.
static void draw_painted_choice(Workspace& workspace) {
  Document& document = *workspace.document();
  Brush& brush = document.brush().brush;
  forget_missing(document, brush);
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("Paints");
  ImGui::SameLine(em(6));
  ImGui::SetNextItemWidth(-1);
  const std::string painted = painted_label(document, brush);
  if (!noted("Paints", ImGui::BeginCombo("##paints", painted.c_str()))) return;
  const auto choose = [&](const std::string& label, const std::string& word) {
    if (noted(label, ImGui::Selectable(label.c_str(), painted_word(brush) == word)))
      paint_instead(word, brush, workspace.preferences);
  };
  choose("Gradient scale β", "beta");
  choose(kKeptEdges, "edges");
  if (document.has_colours()) choose("Gradient scale of colours", "colour");
  if (document.has_colours()) choose(kTextureGain, "texture");
  for (int band = 1; band <= static_cast<int>(document.equaliser().bands.size()); ++band)
    choose(band_label(document, band), "band:" + std::to_string(band));
  for (int curve = 1; curve <= static_cast<int>(document.palette().curves.size()); ++curve)
    choose(curve_label(document, curve), "curve:" + std::to_string(curve));
  ImGui::EndCombo();
}

// ---- The panel ----

static void draw_fall_off(Brush& brush) {
  static const char* const kNames[] = {"Smooth", "Linear", "Sharp", "Constant"};  // as FallOff
  int chosen = static_cast<int>(brush.fall_off);
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("Fall-off");
  ImGui::SameLine(em(6));
  ImGui::SetNextItemWidth(-1);
  if (ImGui::Combo("##falloff", &chosen, kNames, IM_ARRAYSIZE(kNames)))
    brush.fall_off = static_cast<FallOff>(chosen);
}

static void draw_mode_buttons(Brush& brush) {
  struct Mode {
    const char* label;
    double value;
  };
  static constexpr Mode kBeta[] = {{"Smooth", 0}, {"Restore", 1}, {"Sharpen", 2}};
  static constexpr Mode kEdges[] = {{"Keep here", 0}, {"Denoise here", 1}};
  static constexpr Mode kTexture[] = {{"Fade", 0}, {"Restore", 1}, {"Strengthen", 2}};
  std::span<const Mode> modes = kBeta;
  if (brush.edges) modes = kEdges;
  if (brush.texture) modes = kTexture;
  const auto count = static_cast<float>(modes.size());
  const float gaps = (count - 1) * ImGui::GetStyle().ItemSpacing.x;
  const float width = (ImGui::GetContentRegionAvail().x - gaps) / count;
  for (const Mode& mode : modes) {
    if (&mode != &modes.front()) ImGui::SameLine();
    const bool is_on = brush.beta == mode.value;
    if (is_on)
      ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_HeaderActive));
    if (noted(mode.label, ImGui::Button(mode.label, {width, 0}))) brush.beta = mode.value;
    if (is_on) ImGui::PopStyleColor();
  }
}

static void draw_reach(Brush& brush) {
  bool through = !brush.connected;
  noted("Through walls", ImGui::Checkbox("Through walls", &through));
  hint(
      "Paints all surface in the ball, the other side of a thin wall too. Without it the brush "
      "paints what hangs together with the place under the pointer.");
  brush.connected = !through;
}

static std::optional<MirrorPlane> plane_of(int chosen, const Document& document) {
  if (chosen == 0) return std::nullopt;
  return MirrorPlane{chosen - 1, document.box().center()[chosen - 1]};
}

static void draw_mirror(Document& document, MessageLog& log) {
  static const char* const kNames[] = {"Off", "Across x", "Across y", "Across z"};
  std::optional<MirrorPlane>& mirror = document.mirror;
  int chosen = mirror ? mirror->axis + 1 : 0;
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("Mirror");
  hint("Paints each stroke on both sides of a plane, as one step.");
  ImGui::SameLine(em(6));
  ImGui::SetNextItemWidth(-1);
  if (ImGui::Combo("##mirror", &chosen, kNames, IM_ARRAYSIZE(kNames)))
    mirror = plane_of(chosen, document);
  if (!mirror) return;
  const double low = document.box().min()[mirror->axis], high = document.box().max()[mirror->axis];
  linear_slider({{"Mirror plane", low, high}, "%.4g", log}, mirror->at);
}

static void draw_pen(Preferences& preferences) {
  noted("Pen pressure", ImGui::Checkbox("Pen pressure", &preferences.pen_pressure));
  hint("The harder the pen presses, the stronger the brush. Full pressure has the strength above.");
}

static void draw_painted_value(Workspace& workspace) {
  Brush& brush = workspace.document()->brush().brush;
  MessageLog& log = workspace.log;
  draw_painted_choice(workspace);
  if (brush.curve > 0) return;
  if (brush.has_own_limits()) {
    const char* const name = brush.edges ? "Painted strength" : "Painted gain";
    linear_slider({{name, 0, brush.value_max()}, "%.2f", log}, brush.beta);
    return;
  }
  const char* const name = brush.band > 0 ? "Painted gain" : "Painted β";
  beta_slider(name, brush.beta, to_imgui(blue_to_red(signed_part_of_beta(brush.beta))), log);
}

void BrushPanel::draw(Workspace& workspace) {
  Document& document = *workspace.document();
  Brush& brush = document.brush().brush;
  ImGui::BeginDisabled(document.is_viewer());
  ImGui::BeginDisabled(brush.curve > 0);
  draw_mode_buttons(brush);
  ImGui::EndDisabled();
  draw_painted_value(workspace);
  ImGui::TextUnformatted("Radius");
  ImGui::SameLine();
  faint_text("in the scan's units");
  log_slider(
      {{"Radius", 1e-4 * document.diagonal(), 0.5 * document.diagonal()}, "%.3g", workspace.log},
      brush.radius);
  ImGui::TextUnformatted("Strength");
  linear_slider({{"Strength", 0.01, 1}, "%.2f", workspace.log}, brush.strength);
  if (workspace.has_pen) draw_pen(workspace.preferences);
  draw_fall_off(brush);
  draw_reach(brush);
  draw_mirror(document, workspace.log);
  ImGui::EndDisabled();
}

}  // namespace burnish
