#include <algorithm>

#include "client/model/documents/figures.h"
#include "client/panels/panels.h"

namespace burnish {
namespace {

SliderChange show_checks(const Document& document, Controls& controls, Widgets& widgets) {
  const bool may_edit = !document.is_viewer();
  widgets.begin_row(2);
  widgets.enable(may_edit && !document.is_closed());
  bool is_changed = widgets.check(
      "Rims stay", "The rims of an open scan stay where they are. A closed scan has none.",
      controls.pin_rims);
  widgets.enable(may_edit && document.is_closed() && !document.edges().is_on());
  is_changed |= widgets.check(
      "Volume stays",
      "A closed scan keeps its volume. An open scan has none. Not while edges are kept.",
      controls.keep_volume);
  widgets.end_row();
  widgets.enable(may_edit);
  return is_changed ? SliderChange::kDone : SliderChange::kStill;
}

SliderChange show_cap(double any, Controls& controls, Widgets& widgets) {
  double cap = controls.cap > 0 ? std::min(controls.cap, any) : any;
  const SliderChange change =
      widgets.slider({.name = "Largest move",
                      .hint = "In the scan's units. No point of the surface moves farther.",
                      .low = 1e-6 * any,
                      .high = any,
                      .scale = SliderScale::kLogarithmic,
                      .note = "at the right: any"},
                     cap);
  if (change != SliderChange::kStill) controls.cap = cap < any ? cap : 0;
  return change;
}

void show_controls(Document& document, Widgets& widgets) {
  Controls changed = document.controls();
  const SliderChange checks = show_checks(document, changed, widgets);
  widgets.text(rims_text(document).c_str(),
               "The others are small holes, or run over another piece");
  widgets.text(walls_text(document).c_str());
  const SliderChange cap = show_cap(document.diagonal(), changed, widgets);
  follow(std::max(checks, cap), SetControls{changed}, document);
}

void show_lasso(Viewport& viewport, Widgets& widgets) {
  std::optional<LassoWish>& wish = viewport.lasso_wish;
  const auto button = [&](const char* name, const char* hint, bool release) {
    const bool is_on = wish && wish->release == release;
    if (!widgets.button(name, hint, is_on ? Pressed::kYes : Pressed::kNo)) return;
    wish.reset();
    if (!is_on) wish = LassoWish{viewport.lasso_through, release};
  };
  widgets.begin_row(3);
  button("Protect", "Draw a line around what shall not move", false);
  button("Release", "Draw a line around what may move again", true);
  widgets.check("Through", "The line also takes surface that faces away", viewport.lasso_through);
  if (wish) wish->through = viewport.lasso_through;
  widgets.end_row();
}

void show_region(const std::optional<Vec3d>& piece, Document& document, Widgets& widgets) {
  const auto button = [&](const char* name, const char* hint, Protect change) {
    if (widgets.button(name, hint)) document.protect(std::move(change));
  };
  widgets.begin_row(3);
  button("Grow", "The region grows by a cell of the grid", {GrownRegion{1}});
  button("Shrink", "The region shrinks by a cell of the grid", {GrownRegion{-1}});
  button("Invert", "The region becomes what is not protected now", {InvertedRegion{}});
  widgets.end_row();
  widgets.begin_row(3);
  widgets.enable(piece && !document.is_viewer());
  button("Piece", "Protects the whole piece that the pointer was on last",
         {PieceRegion{piece.value_or(Vec3d::Zero())}});
  widgets.enable(!document.is_viewer());
  button("Clear", "Nothing is protected", {NoRegion{}});
  widgets.end_row();
}

}  // namespace

void show_limits(Workspace& workspace, Widgets& widgets) {
  Document& document = *workspace.document();
  Viewport& viewport = workspace.viewport;
  widgets.enable(!document.is_viewer());
  show_controls(document, widgets);
  show_lasso(viewport, widgets);
  show_region(viewport.last_hover(), document, widgets);
  widgets.text(
      viewport.lasso_wish ? "drag a line in the picture" : "the protected region is hatched", "",
      true);
}

}  // namespace burnish
