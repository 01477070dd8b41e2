#include "client/app/overlay/colour_bar.h"

#include "client/app/widgets/places.h"
#include "client/app/widgets/theme.h"
#include "client/model/view/colour_scale.h"
#include "client/tools/colours.h"

namespace burnish {

namespace {

constexpr float kBarWidthEm = 14, kBarHeightEm = 0.8f;

ImU32 colour_at(float part) {
  return ImGui::ColorConvertFloat4ToU32(to_imgui(blue_to_red(part)));
}

void draw_bar(const ImVec2& at) {
  ImDrawList* const list = ImGui::GetWindowDrawList();
  const float middle = at.x + em(kBarWidthEm / 2), right = at.x + em(kBarWidthEm);
  const float bottom = at.y + em(kBarHeightEm);
  const ImU32 blue = colour_at(-1), grey = colour_at(0), red = colour_at(1);
  list->AddRectFilledMultiColor(at, {middle, bottom}, blue, grey, grey, blue);
  list->AddRectFilledMultiColor({middle, at.y}, {right, bottom}, grey, red, red, grey);
}

void draw_mark(const ImVec2& at, const ColourScale& scale) {
  const float x = at.x + em(kBarWidthEm) * static_cast<float>(scale.part + 1) / 2;
  const float y = at.y + em(kBarHeightEm), side = em(0.35f);
  const ImU32 colour = ImGui::ColorConvertFloat4ToU32(theme::kText);
  ImGui::GetWindowDrawList()->AddTriangleFilled({x, y - side}, {x - side, y + side},
                                                {x + side, y + side}, colour);
}

void draw_ends(const ColourScale& scale) {
  const float left = ImGui::GetCursorPosX(), width = em(kBarWidthEm);
  ImGui::TextUnformatted(scale.low.c_str());
  ImGui::SameLine(left + (width - ImGui::CalcTextSize(scale.middle.c_str()).x) / 2);
  ImGui::TextUnformatted(scale.middle.c_str());
  ImGui::SameLine(left + width - ImGui::CalcTextSize(scale.high.c_str()).x);
  ImGui::TextUnformatted(scale.high.c_str());
}

}  // namespace

void ColourBar::draw(Workspace& workspace) {
  top = lower_right.y;
  const auto scale = colour_scale(*workspace.document(), workspace.viewport);
  if (!scale) return;
  const float margin = em(0.7f);
  ImGui::SetNextWindowPos({lower_right.x - margin, lower_right.y - margin}, 0, {1, 1});
  ImGui::SetNextWindowBgAlpha(0.86f);
  ImGui::Begin("##colour_bar", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs |
                   ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoNav |
                   ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoSavedSettings);
  faint_text("%s", scale->title.c_str());
  if (!scale->value.empty()) {
    ImGui::SameLine();
    ImGui::TextUnformatted(scale->value.c_str());
  }
  const ImVec2 at = ImGui::GetCursorScreenPos();
  draw_bar(at);
  ImGui::Dummy({em(kBarWidthEm), em(kBarHeightEm + 0.3f)});
  if (!scale->value.empty()) draw_mark(at, *scale);
  draw_ends(*scale);
  top = ImGui::GetWindowPos().y;
  note_window("Colour bar");
  ImGui::End();
}

}  // namespace burnish
