#include "client/app/overlay/guides_overlay.h"

#include <algorithm>
#include <string>

#include "client/app/widgets/places.h"
#include "client/app/widgets/theme.h"
#include "client/report/length_text.h"

namespace burnish {

namespace {

constexpr float kGuideMarginEm = 0.7f, kGuidePadEm = 0.4f;
constexpr float kBarEndEm = 0.4f;  // height of the bar's ends
constexpr float kBehindEnds = 0.35f, kFaintEnd = 0.55f;

ImU32 colour_u32(ImVec4 colour, float opacity) {
  colour.w = opacity;
  return ImGui::ColorConvertFloat4ToU32(colour);
}

/// The colours that axes have in other programs too: x red, y green, z blue.
ImVec4 colour_of_axis(UpAxis axis) {
  static const ImVec4 kAxisColours[] = {
      {0.95f, 0.38f, 0.35f, 1.0f}, {0.50f, 0.80f, 0.30f, 1.0f}, {0.42f, 0.64f, 1.00f, 1.0f}};
  return kAxisColours[static_cast<int>(axis) % 3];
}

bool is_positive(UpAxis axis) {
  return axis <= UpAxis::kZ;
}

void draw_letters(const std::string& letters, const ImVec2& middle, ImU32 colour) {
  constexpr float kSmaller = 0.86f;
  const ImVec2 size = ImGui::CalcTextSize(letters.c_str());
  ImGui::GetBackgroundDrawList()->AddText(
      ImGui::GetFont(), em(kSmaller),
      {middle.x - kSmaller * size.x / 2, middle.y - kSmaller * size.y / 2}, colour,
      letters.c_str());
}

void draw_end(const AxisEnd& end, const ImVec2& place, float radius, bool is_pointed) {
  ImDrawList* const list = ImGui::GetBackgroundDrawList();
  const ImVec4 colour = colour_of_axis(end.axis);
  const std::string name(name_of(end.axis));
  list->AddCircleFilled(place, radius, colour_u32(theme::kOnPicture, 1));
  list->AddCircleFilled(place, radius, colour_u32(colour, is_positive(end.axis) ? 1 : kFaintEnd));
  if (is_pointed) list->AddCircle(place, radius, IM_COL32_WHITE, 0, em(0.12f));
  if (is_positive(end.axis) || is_pointed)
    draw_letters(name, place, colour_u32(theme::kOnPicture, 1));
  note_area("Axis " + name, {place.x - radius, place.y - radius},
            {place.x + radius, place.y + radius});
}

}  // namespace

void draw_scale_bar_overlay(const Workspace& workspace, const ImVec2& lower_right,
                            const ImVec2& pixels) {
  const auto bar = workspace.viewport.scale_bar();
  if (!bar) return;
  const std::string text = length_text(bar->length, workspace.document()->unit());
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  const float length = static_cast<float>(bar->pixels) / pixels.x, pad = em(kGuidePadEm);
  const float width = std::max(length, size.x) + 2 * pad;
  const ImVec2 high{lower_right.x - em(kGuideMarginEm), lower_right.y - em(kGuideMarginEm)};
  const ImVec2 low{high.x - width, high.y - size.y - em(kBarEndEm) - 2 * pad};
  const float middle = (low.x + high.x) / 2, left = middle - length / 2, right = left + length;
  const float line = high.y - pad, top = line - em(kBarEndEm), thick = em(0.12f);
  const ImU32 colour = ImGui::ColorConvertFloat4ToU32(theme::kText);
  ImDrawList* const list = ImGui::GetBackgroundDrawList();
  list->AddRectFilled(low, high, ImGui::GetColorU32(ImGuiCol_WindowBg, 0.86f), em(0.2f));
  list->AddText({middle - size.x / 2, low.y + pad / 2}, colour, text.c_str());
  list->AddRectFilled({left, line - thick}, {right, line}, colour);
  list->AddRectFilled({left, top}, {left + thick, line}, colour);
  list->AddRectFilled({right - thick, top}, {right, line}, colour);
  note_area("Scale bar", low, high);
}

void draw_axes_overlay(const Workspace& workspace, const ImVec2& at, const ImVec2& pixels) {
  const auto gizmo = workspace.viewport.axes();
  if (!gizmo) return;
  const auto on_screen = [&](const Eigen::Vector2d& place) {
    return ImVec2{at.x + static_cast<float>(place.x()) / pixels.x,
                  at.y + static_cast<float>(place.y()) / pixels.y};
  };
  const auto pointed = workspace.viewport.pointed_axis();
  const ImVec2 middle = on_screen(gizmo->middle);
  ImDrawList* const list = ImGui::GetBackgroundDrawList();
  list->AddCircleFilled(middle, static_cast<float>(gizmo->radius) / pixels.x,
                        colour_u32(theme::kOnPicture, kBehindEnds));
  const float radius = static_cast<float>(gizmo->end_radius) / pixels.x;
  for (const AxisEnd& end : gizmo->ends) {
    const ImVec2 place = on_screen(end.place);
    if (is_positive(end.axis))
      list->AddLine(middle, place, colour_u32(colour_of_axis(end.axis), 1), em(0.15f));
    draw_end(end, place, radius, pointed == end.axis);
    if (pointed == end.axis) ImGui::SetTooltip("from the %s", name_of(end.view).data());
  }
}

}  // namespace burnish
