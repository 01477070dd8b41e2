#include "server/session/layer_check.h"

namespace burnish {

Status LayerCheck::check_brush(const Brush& brush) const {
  if (brush.band > static_cast<int>(bands_))
    return failed_precondition("the brush paints the gain of band " + std::to_string(brush.band) +
                               ", the equaliser has " + std::to_string(bands_));
  if (brush.curve > static_cast<int>(palette_.curves.size()))
    return failed_precondition("the brush paints curve " + std::to_string(brush.curve) +
                               ", the palette has " + std::to_string(palette_.curves.size()));
  return Status::ok();
}

Status LayerCheck::check(const Edit& edit) const {
  if (const auto* stroke = std::get_if<Stroke>(&edit.change)) return check_brush(stroke->brush);
  if (const auto* change = std::get_if<SetPalette>(&edit.change))
    return check_beside(change->palette, curve_);
  if (const auto* change = std::get_if<SetTransferCurve>(&edit.change))
    return check_beside(palette_, change->curve);
  return Status::ok();
}

Status LayerCheck::take(const Edit& edit) {
  if (is_known_) RETURN_IF_ERROR(check(edit));
  if (const auto* change = std::get_if<SetEqualiser>(&edit.change))
    bands_ = change->equaliser.bands.size();
  if (const auto* change = std::get_if<SetPalette>(&edit.change)) palette_ = change->palette;
  if (const auto* change = std::get_if<SetTransferCurve>(&edit.change)) curve_ = change->curve;
  if (!makes_fields(kind_of(edit))) is_known_ = false;
  return Status::ok();
}

}  // namespace burnish
