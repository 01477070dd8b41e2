#include "client/app/panels/panels.h"
#include "client/app/widgets/places.h"
#include "client/app/widgets/theme.h"
#include "client/app/widgets/value_slider.h"

namespace burnish {

static void draw_colours(Document& document, Workspace& workspace) {
  static const char* const kNames[] = {"Clay", "Gradient scale β", "Curvature", "Displacement",
                                       "Colours of the scan"};  // as ColourBy
  const int count = IM_ARRAYSIZE(kNames) - (document.has_colours() ? 0 : 1);
  const int chosen = static_cast<int>(document.colour());
  ImGui::SetNextItemWidth(-1);
  if (noted("Colour", ImGui::BeginCombo("##colour", kNames[chosen]))) {
    for (int i = 0; i < count; ++i)
      if (noted(kNames[i], ImGui::Selectable(kNames[i], i == chosen)))
        document.set_colour(static_cast<ColourBy>(i));
    ImGui::EndCombo();
  }
  if (document.colour() == ColourBy::kDisplacement) {
    faint_text("full colour at this many cells");
    log_slider({{"Displacement", 0.05, 20}, "%.2g", workspace.log},
               workspace.viewport.options.displacement_range);
  }
}

static void draw_toggles(ViewOptions& options) {
  ImGui::Checkbox("Flat", &options.flat);
  hint("Gives each triangle one shade.");
  ImGui::SameLine(em(7));
  ImGui::Checkbox("Wireframe", &options.wireframe);
  ImGui::Checkbox("Split", &options.split);
  hint(
      "Shows the original on the left, the edited surface on the right. Hold Space to see the "
      "original "
      "everywhere.");
  if (!options.split) return;
  ImGui::SameLine(em(7));
  auto at = static_cast<float>(options.split_at);
  ImGui::SetNextItemWidth(-1);
  if (ImGui::SliderFloat("##split", &at, 0.05f, 0.95f, "", ImGuiSliderFlags_NoInput))
    options.split_at = at;
}

static void draw_bookmarks(Viewport& viewport) {
  if (noted("Frame all", ImGui::Button("Frame all"))) viewport.frame_all();
  ImGui::SameLine();
  if (ImGui::Button("Bookmark")) viewport.add_bookmark();
  for (size_t i = 0; i < viewport.bookmarks.size(); ++i) {
    ImGui::PushID(static_cast<int>(i));
    if (i % 6 != 0) ImGui::SameLine();
    const std::string name = std::to_string(i + 1);
    if (ImGui::Button(name.c_str(), {em(1.9f), 0})) viewport.camera = viewport.bookmarks[i];
    ImGui::PopID();
  }
}

void ViewPanel::draw(Workspace& workspace) {
  Document& document = *workspace.document();
  draw_colours(document, workspace);
  draw_toggles(workspace.viewport.options);
  draw_bookmarks(workspace.viewport);
  ImGui::Checkbox("Left button turns the view", &workspace.viewport.navigate_mode);
  ImGui::PushTextWrapPos(0);
  faint_text("%s", status_text(document.surface().status()).c_str());
  faint_text("depth %d", document.depth());
  ImGui::PopTextWrapPos();
}

}  // namespace burnish
