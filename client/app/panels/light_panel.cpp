#include <algorithm>
#include <iterator>

#include "client/app/panels/panels.h"
#include "client/app/widgets/places.h"
#include "client/app/widgets/theme.h"
#include "client/app/widgets/value_slider.h"

namespace burnish {

static constexpr const char* kLightNames[] = {
    "Clay",    "Radiance scaling", "Cavity", "Raking light",
    "Ceramic", "Bronze",           "Slopes", "Unlit"};  // as LightKind
static constexpr const char* kLightHints[] = {
    "A lamp, the sky and a weak second lamp.",
    "Brightens what bends outwards and darkens what bends inwards.",
    "Bright ridges and dark valleys.",
    "One hard lamp. Low over the surface it shows the finest relief.",
    "White glaze with bright windows.",
    "Dark metal.",
    "Each direction of a slope has its own tone.",
    "The colours alone, without light."};  // as LightKind

static_assert(std::size(kLightNames) == kLightKinds && std::size(kLightHints) == kLightKinds);

static void draw_kind(Lighting& lighting) {
  ImGui::SetNextItemWidth(-1);
  const auto chosen = static_cast<size_t>(lighting.kind);
  if (!ImGui::BeginCombo("##light", kLightNames[chosen], ImGuiComboFlags_HeightLarge)) return;
  for (size_t i = 0; i < kLightKinds; ++i) {
    if (ImGui::Selectable(kLightNames[i], i == chosen)) lighting.kind = static_cast<LightKind>(i);
    hint(kLightHints[i]);
  }
  ImGui::EndCombo();
}

// A drag on the ball moves the lamp: the middle is the eye, the rim the picture's plane.
static void draw_ball(Lighting& lighting) {
  const float radius = em(2.6f);
  const ImVec2 from = ImGui::GetCursorScreenPos();
  const ImVec2 middle{from.x + radius, from.y + radius};
  ImGui::InvisibleButton("##lamp", {2 * radius, 2 * radius});
  hint("Drag the lamp. In the picture: Ctrl+Shift and a drag with the right button.");
  if (ImGui::IsItemActive()) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    lighting =
        with_lamp_at(lighting, {(mouse.x - middle.x) / radius, (middle.y - mouse.y) / radius});
  }
  const Eigen::Vector2f lamp = lamp_on_ball(lighting).cast<float>();
  ImDrawList* const list = ImGui::GetWindowDrawList();
  list->AddCircleFilled(middle, radius, ImGui::GetColorU32(ImGuiCol_FrameBg), 48);
  constexpr int kRings = 14;
  for (int ring = 0; ring < kRings; ++ring) {  // brighter towards the lamp
    const float part = static_cast<float>(ring) / kRings;
    const float away = part * radius;
    list->AddCircleFilled({middle.x + away * lamp.x(), middle.y - away * lamp.y()},
                          radius * (1 - part), IM_COL32(255, 245, 225, 18), 48);
  }
  list->AddCircleFilled({middle.x + radius * lamp.x(), middle.y - radius * lamp.y()}, em(0.35f),
                        ImGui::GetColorU32(theme::kAccent), 16);
}

static void draw_strength(const char* name, double high, double& value, MessageLog& log) {
  ImGui::TextUnformatted(name);
  linear_slider({{name, 0, high}, "%.2f", log}, value);
}

static void draw_strengths(Lighting& lighting, MessageLog& log) {
  const bool has_lamp = lighting.kind <= LightKind::kRaking;
  if (lighting.kind == LightKind::kRadiance)
    draw_strength("Scaling", kRadianceMax, lighting.radiance, log);
  if (lighting.kind == LightKind::kCavity) {
    draw_strength("Ridges", kCavityMax, lighting.ridge, log);
    draw_strength("Valleys", kCavityMax, lighting.valley, log);
  }
  if (has_lamp) draw_strength("Highlight", 1, lighting.specular, log);
  draw_strength("Occlusion", 1, lighting.occlusion, log);
}

void LightPanel::draw(Workspace& workspace) {
  Lighting& lighting = workspace.viewport.options.lighting;
  draw_kind(lighting);
  if (lighting.kind <= LightKind::kRaking) draw_ball(lighting);
  draw_strengths(lighting, workspace.log);
  if (noted("As at first", ImGui::Button("As at first"))) lighting = {};
}

}  // namespace burnish
