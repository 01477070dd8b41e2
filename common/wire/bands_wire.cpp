#include "common/wire/bands_wire.h"

#include <algorithm>
#include <limits>

#include "common/wire/edit_wire.h"

namespace burnish {

v1::Equaliser to_wire(const Equaliser& equaliser) {
  v1::Equaliser message;
  for (const Band& band : equaliser.bands) {
    v1::Band* sent = message.add_bands();
    sent->set_size(band.size);
    sent->set_gain(band.gain);
  }
  return message;
}

Equaliser from_wire(const v1::Equaliser& message) {
  Equaliser equaliser;
  for (const v1::Band& band : message.bands())
    equaliser.bands.push_back({band.size(), band.gain()});
  return equaliser;
}

v1::Palette to_wire(const Palette& palette) {
  v1::Palette message;
  for (const PaletteCurve& curve : palette.curves) {
    v1::PaletteCurve* sent = message.add_curves();
    sent->set_name(curve.name);
    sent->set_colour(curve.colour);
    *sent->mutable_curve() = to_wire(curve.curve);
  }
  return message;
}

Result<Palette> from_wire(const v1::Palette& message) {
  Palette palette;
  for (const v1::PaletteCurve& sent : message.curves()) {
    const std::string where = "curve " + std::to_string(palette.curves.size() + 1);
    auto curve = from_wire(sent.curve());
    if (!curve.is_ok()) return curve.status().with_context(where);
    palette.curves.push_back({sent.name(), sent.colour(), std::move(curve).value()});
  }
  return palette;
}

v1::ColourFilter to_wire(const ColourFilter& filter) {
  v1::ColourFilter message;
  message.set_alpha(filter.alpha);
  message.set_beta(filter.beta);
  return message;
}

ColourFilter from_wire(const v1::ColourFilter& message, bool is_there) {
  if (!is_there) return {};
  return {message.alpha(), message.beta()};
}

v1::EdgeFilter to_wire(const EdgeFilter& filter) {
  v1::EdgeFilter message;
  message.set_strength(filter.strength);
  message.set_kind(filter.kind == NormalFilterKind::kEdges ? v1::NORMAL_FILTER_KIND_EDGES
                                                           : v1::NORMAL_FILTER_KIND_BILATERAL);
  message.set_edge_angle(filter.edge_angle);
  message.set_passes(static_cast<uint32_t>(filter.passes));
  message.set_crispness(filter.crispness);
  return message;
}

Result<EdgeFilter> from_wire(const v1::EdgeFilter& message) {
  if (message.kind() < v1::NORMAL_FILTER_KIND_UNSPECIFIED ||
      message.kind() > v1::NORMAL_FILTER_KIND_EDGES)
    return invalid_argument("filter of normals " + std::to_string(message.kind()) +
                            " is none of 1 (bilateral), 2 (edges)");
  constexpr uint32_t kNumbersMax = std::numeric_limits<int>::max();
  return EdgeFilter{message.strength(),
                    message.kind() == v1::NORMAL_FILTER_KIND_EDGES ? NormalFilterKind::kEdges
                                                                   : NormalFilterKind::kBilateral,
                    message.edge_angle(), static_cast<int>(std::min(message.passes(), kNumbersMax)),
                    message.crispness()};
}

}  // namespace burnish
