#include <algorithm>

#include "client/app/panels/panels.h"
#include "client/app/widgets/places.h"
#include "client/app/widgets/theme.h"
#include "client/app/widgets/value_slider.h"
#include "client/model/documents/figures.h"

namespace burnish {
static float third_of_panel() {
  return (ImGui::GetContentRegionAvail().x - 2 * ImGui::GetStyle().ItemSpacing.x) / 3;
}

static void draw_region_buttons(Document& document) {
  const float width = third_of_panel();
  const auto button = [&](const char* label, const char* what, Protect change) {
    if (noted(label, ImGui::Button(label, {width, 0}))) document.protect(std::move(change));
    hint(what);
  };
  button("Grow", "The region grows by a cell of the grid", {GrownRegion{1}});
  ImGui::SameLine();
  button("Shrink", "The region shrinks by a cell of the grid", {GrownRegion{-1}});
  ImGui::SameLine();
  button("Invert", "The region becomes what is not protected now", {InvertedRegion{}});
}

void ProtectPanel::draw_lasso_buttons(Viewport& viewport) {
  const float width = third_of_panel();
  const auto button = [&](const char* label, const char* what, bool release) {
    const bool is_on = viewport.lasso_wish && viewport.lasso_wish->release == release;
    if (is_on)
      ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_HeaderActive));
    if (noted(label, ImGui::Button(label, {width, 0}))) {
      viewport.lasso_wish.reset();
      if (!is_on) viewport.lasso_wish = LassoWish{through_, release};
    }
    hint(what);
    if (is_on) ImGui::PopStyleColor();
  };
  button("Protect", "Draw a line around what shall not move", false);
  ImGui::SameLine();
  button("Release", "Draw a line around what may move again", true);
  ImGui::SameLine();
  if (ImGui::Checkbox("Through", &through_) && viewport.lasso_wish)
    viewport.lasso_wish->through = through_;
  hint("The line also takes surface that faces away");
}

void ProtectPanel::draw_piece_buttons(Workspace& workspace) {
  const float width = third_of_panel();
  Document& document = *workspace.document();
  if (const auto& hover = workspace.viewport.hover()) last_hover_ = hover->original;
  ImGui::BeginDisabled(!last_hover_);
  if (noted("Piece", ImGui::Button("Piece", {width, 0})))
    document.protect({PieceRegion{last_hover_.value_or(Vec3d::Zero())}});
  hint("Protects the whole piece that the pointer was on last");
  ImGui::EndDisabled();
  ImGui::SameLine();
  if (noted("Clear", ImGui::Button("Clear", {width, 0}))) document.protect({NoRegion{}});
  hint("Nothing is protected");
}

static void draw_cap(Document& document, MessageLog& log) {
  ImGui::TextUnformatted("Largest move");
  ImGui::SameLine();
  faint_text("at the right: any");
  hint("In the scan's units. No point of the surface moves farther.");
  const double any = document.diagonal();
  Controls controls = document.controls();
  double cap = controls.cap > 0 ? std::min(controls.cap, any) : any;
  const SliderChange change = log_slider({{"Largest move", 1e-6 * any, any}, "%.3g", log}, cap);
  if (change == SliderChange::kStill) return;
  controls.cap = cap < any ? cap : 0;
  if (change == SliderChange::kDone) {
    document.set_controls(controls);
  } else {
    document.preview(SetControls{controls});
  }
}

static void draw_controls(Document& document, MessageLog& log) {
  Controls controls = document.controls();
  ImGui::BeginDisabled(document.is_closed());
  bool is_changed = ImGui::Checkbox("Rims stay", &controls.pin_rims);
  ImGui::EndDisabled();
  hint("The rims of an open scan stay where they are. A closed scan has none.");
  ImGui::SameLine(em(9));
  ImGui::BeginDisabled(!document.is_closed() || document.edges().is_on());
  is_changed |= ImGui::Checkbox("Volume stays", &controls.keep_volume);
  ImGui::EndDisabled();
  hint("A closed scan keeps its volume. An open scan has none. Not while edges are kept.");
  if (is_changed) document.set_controls(controls);
  if (const std::string rims = rims_text(document); !rims.empty()) {
    faint_text("%s", rims.c_str());
    hint("The others are small holes, or run over another piece");
  }
  if (const std::string walls = walls_text(document); !walls.empty()) {
    ImGui::PushTextWrapPos(0);
    faint_text("%s", walls.c_str());
    ImGui::PopTextWrapPos();
  }
  draw_cap(document, log);
}

void ProtectPanel::draw(Workspace& workspace) {
  Document& document = *workspace.document();
  ImGui::BeginDisabled(document.is_viewer());
  draw_controls(document, workspace.log);
  draw_lasso_buttons(workspace.viewport);
  draw_region_buttons(document);
  draw_piece_buttons(workspace);
  ImGui::EndDisabled();
  faint_text(workspace.viewport.lasso_wish ? "drag a line in the picture"
                                           : "the protected region is hatched");
}

}  // namespace burnish
