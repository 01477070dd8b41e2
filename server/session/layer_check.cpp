#include "server/session/layer_check.h"

#include "server/fields/paint_layer.h"

namespace burnish {

Settings counting_beside_edges(Settings settings, bool edges_are_painted) {
  if (!settings.edges.is_on() && !edges_are_painted) return settings;
  settings.equaliser = {};
  settings.controls.keep_volume = false;
  return settings;
}

Status LayerCheck::check_brush(const Brush& brush) const {
  const size_t bands = settings_.equaliser.bands.size(), curves = settings_.palette.curves.size();
  if (brush.band > static_cast<int>(bands))
    return failed_precondition("the brush paints the gain of band " + std::to_string(brush.band) +
                               ", the equaliser has " + std::to_string(bands));
  if (brush.curve > static_cast<int>(curves))
    return failed_precondition("the brush paints curve " + std::to_string(brush.curve) +
                               ", the palette has " + std::to_string(curves));
  return Status::ok();
}

Status LayerCheck::check_beside_edges() const {
  if (!settings_.edges.is_on() && !edges_are_painted_) return Status::ok();
  if (settings_.controls.keep_volume)
    return failed_precondition("the volume cannot be kept while edges are kept");
  if (!settings_.equaliser.bands.empty())
    return failed_precondition("bands cannot stand beside kept edges: they have the scan's noise");
  return Status::ok();
}

Status LayerCheck::check(const Edit& edit, const LayerCheck& after) const {
  RETURN_IF_ERROR(after.check_beside_edges());
  if (const auto* stroke = std::get_if<Stroke>(&edit.change)) return check_brush(stroke->brush);
  const Settings& next = after.settings_;
  if (next.palette == settings_.palette && next.curve == settings_.curve) return Status::ok();
  return check_beside(next.palette, next.curve);
}

Status LayerCheck::take(const Edit& edit) {
  LayerCheck after = *this;
  after.settings_.take(edit.change);
  after.edges_are_painted_ |= painted_layer(edit.change) == kEdgesLayer;
  if (is_known_) RETURN_IF_ERROR(check(edit, after));
  after.is_known_ &= makes_fields(kind_of(edit));
  *this = std::move(after);
  return Status::ok();
}

}  // namespace burnish
