#include "server/session/layer_check.h"

namespace burnish {

Settings counting_beside_edges(Settings settings) {
  if (!settings.edges.is_on()) return settings;
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

Status LayerCheck::check(const Edit& edit, const Settings& after) const {
  if (const auto* stroke = std::get_if<Stroke>(&edit.change)) return check_brush(stroke->brush);
  if (after.edges.is_on() && after.controls.keep_volume)
    return failed_precondition("the volume cannot be kept while edges are kept");
  if (after.edges.is_on() && !after.equaliser.bands.empty())
    return failed_precondition("bands cannot stand beside kept edges: they have the scan's noise");
  if (after.palette == settings_.palette && after.curve == settings_.curve) return Status::ok();
  return check_beside(after.palette, after.curve);
}

Status LayerCheck::take(const Edit& edit) {
  Settings after = settings_;
  after.take(edit.change);
  if (is_known_) RETURN_IF_ERROR(check(edit, after));
  settings_ = std::move(after);
  if (!makes_fields(kind_of(edit))) is_known_ = false;
  return Status::ok();
}

}  // namespace burnish
