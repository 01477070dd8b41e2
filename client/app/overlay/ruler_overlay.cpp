#include "client/app/overlay/ruler_overlay.h"

#include "client/app/widgets/theme.h"
#include "client/report/length_text.h"

namespace burnish {

void draw_ruler_overlay(const Workspace& workspace, const ImVec2& at, const ImVec2& pixels) {
  const Document& document = *workspace.document();
  const Ruler& ruler = document.measuring().ruler;
  ImDrawList* const list = ImGui::GetBackgroundDrawList();
  const ImU32 colour = ImGui::ColorConvertFloat4ToU32(theme::kBusy);
  const ImU32 dark = ImGui::ColorConvertFloat4ToU32(theme::kPanel);
  std::vector<ImVec2> places;
  for (const Ruler::End& end : ruler.ends()) {
    const Eigen::Vector2d pixel =
        pixel_of(workspace.viewport.camera, workspace.viewport.size(), end.edited);
    places.push_back({at.x + static_cast<float>(pixel.x()) / pixels.x,
                      at.y + static_cast<float>(pixel.y()) / pixels.y});
    list->AddCircleFilled(places.back(), em(0.3f), colour);
    list->AddCircle(places.back(), em(0.3f), dark);
  }
  if (places.size() < 2) return;
  list->AddLine(places[0], places[1], dark, em(0.2f));
  list->AddLine(places[0], places[1], colour, em(0.1f));
  const std::string text = length_text(*ruler.length(), document.unit(), kRulerDigits);
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  const ImVec2 middle{(places[0].x + places[1].x) / 2 + em(0.5f),
                      (places[0].y + places[1].y) / 2 + em(0.5f)};
  list->AddRectFilled({middle.x - em(0.2f), middle.y},
                      {middle.x + size.x + em(0.2f), middle.y + size.y}, dark);
  list->AddText(middle, colour, text.c_str());
}

}  // namespace burnish
