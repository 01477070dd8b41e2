#include <imgui.h>
#include <imgui_stdlib.h>

#include "client/app/panels/panels.h"
#include "client/app/widgets/places.h"
#include "client/app/widgets/theme.h"
#include "client/panels/panels.h"

namespace burnish {
namespace {

// Colours that are easy to tell apart.
constexpr uint32_t kColours[] = {0xd9534f, 0x4a7fd0, 0x4caf6d, 0xe0a030,
                                 0x9b6bd3, 0x36b3b3, 0xd06fa8, 0x8a8a5a};

ImVec4 to_colour(uint32_t rgb) {
  const auto part = [&](int shift) { return static_cast<float>(rgb >> shift & 0xff) / 255; };
  return {part(16), part(8), part(0), 1};
}

uint32_t from_colour(const float* rgb) {
  uint32_t colour = 0;
  for (int i = 0; i < 3; ++i) colour = colour << 8 | static_cast<uint32_t>(rgb[i] * 255 + 0.5f);
  return colour;
}

/// Draws a curve's row. Returns true if `palette` has changed.
bool draw_curve_row(Workspace& workspace, Palette& palette, size_t index) {
  Document& document = *workspace.document();
  PaletteCurve& curve = palette.curves[index];
  const int number = static_cast<int>(index) + 1;
  ImVec4 colour = to_colour(curve.colour);
  bool is_changed = false;
  if (ImGui::ColorEdit3("##colour", &colour.x,
                        ImGuiColorEditFlags_NoInputs | ImGuiColorEditFlags_NoLabel)) {
    curve.colour = from_colour(&colour.x);
    document.preview(SetPalette{palette});
  }
  is_changed |= ImGui::IsItemDeactivatedAfterEdit();
  ImGui::SameLine();
  const float end = em(7.5f);
  const bool is_painted = document.brush().brush.curve == number;
  if (noted(curve.name, ImGui::Selectable(curve.name.c_str(), is_painted, 0,
                                          {ImGui::GetContentRegionAvail().x - end, 0})))
    paint_instead(is_painted ? "beta" : ("curve:" + std::to_string(number)).c_str(), workspace);
  hint("The brush paints where this curve rules");
  ImGui::SameLine();
  if (ImGui::SmallButton("set")) {
    curve.curve = document.curve().curve();
    is_changed = true;
  }
  hint("Takes the transfer curve as it is above");
  ImGui::SameLine();
  if (ImGui::SmallButton("show")) {
    document.curve().set_curve(curve.curve);
    document.preview_curve();
    document.commit_curve();
  }
  hint("Makes it the transfer curve of all that is not painted");
  return is_changed;
}

}  // namespace

void PalettePanel::draw(Workspace& workspace) {
  Document& document = *workspace.document();
  ImGui::BeginDisabled(document.is_viewer());
  Palette palette = document.palette();
  bool is_changed = false;
  for (size_t i = 0; i < palette.curves.size(); ++i) {
    ImGui::PushID(static_cast<int>(i));
    is_changed |= draw_curve_row(workspace, palette, i);
    ImGui::PopID();
  }
  if (palette.curves.size() < kPaletteCurvesMax) {
    ImGui::SetNextItemWidth(-em(4));
    ImGui::InputTextWithHint("##name", "name for this curve", &name_);
    note_place("Name");
    ImGui::SameLine();
    ImGui::BeginDisabled(name_.empty());
    if (noted("Add", ImGui::Button("Add", {-1, 0}))) {
      palette.curves.push_back(
          {name_, kColours[palette.curves.size() % std::size(kColours)], document.curve().curve()});
      const Status status = check_palette(palette);
      if (!status.is_ok()) workspace.log.failure("palette", status);
      if (status.is_ok()) name_.clear();
      is_changed = status.is_ok();
    }
    ImGui::EndDisabled();
    hint("Adds the transfer curve as it is. A brush then paints where it rules.");
  }
  if (!palette.curves.empty() && ImGui::Button("Remove the last curve", {-1, 0})) {
    palette.curves.pop_back();
    is_changed = true;
  }
  if (is_changed) document.commit(SetPalette{palette});
  ImGui::EndDisabled();
}

}  // namespace burnish
