#include "client/app/panels/raw_facts.h"

#include "client/app/widgets/depth_list.h"
#include "client/app/widgets/places.h"
#include "client/app/widgets/theme.h"
#include "client/app/widgets/words.h"
#include "client/report/depth_text.h"

namespace burnish {

static constexpr const char* kMovesText =
    "Drag turns it, with Shift or the right button moves it, the wheel zooms.";

static void draw_depth_choice(Workspace& workspace) {
  const MeshStatistics& scan = workspace.raw()->statistics;
  const auto choices = depth_choices(scan, "", workspace.server_memory_bytes(), 0);
  const int chosen = workspace.chosen_depth() > 0 ? workspace.chosen_depth() : default_of(choices);
  ImGui::TextUnformatted("Depth of the grid");
  ImGui::SetNextItemWidth(-1);
  if (noted("Depth", ImGui::BeginCombo("##depth", std::to_string(chosen).c_str(),
                                       ImGuiComboFlags_HeightLargest))) {
    if (const auto depth = draw_depth_list(choices, chosen)) workspace.choose_depth(*depth);
    ImGui::EndCombo();
  }
  hint("A deeper grid keeps finer details, and takes more memory and time.");
  faint_text("%s", choices[static_cast<size_t>(chosen - kDepthMin)].text.c_str());
  faint_text("%s", edges_text(scan, "", chosen).c_str());
}

static void draw_preparing(Workspace& workspace) {
  ImGui::TextUnformatted("The scan is being prepared. The tools appear here when it is ready.");
  faint_text("%s", kMovesText);
  ImGui::Dummy({0, em(0.6f)});
  draw_depth_choice(workspace);
}

static void draw_opening() {
  ImGui::TextUnformatted("The session is being opened. The tools appear here when it is ready.");
  faint_text("The picture is a coarse one of the scan, without its edits.");
  faint_text("%s", kMovesText);
}

void draw_raw_facts(Workspace& workspace) {
  const RawScan& scan = *workspace.raw();
  begin_place_group("Raw");
  text_with_ellipsis(scan.name, ImGui::GetContentRegionAvail().x);
  faint_text("%s vertices, %s triangles", counted(scan.vertices).c_str(),
             counted(scan.triangles).c_str());
  faint_text("%s", megabytes(scan.size_bytes).c_str());
  ImGui::Dummy({0, em(0.6f)});
  ImGui::PushTextWrapPos(0);
  scan.file.empty() ? draw_opening() : draw_preparing(workspace);
  ImGui::PopTextWrapPos();
}

}  // namespace burnish
