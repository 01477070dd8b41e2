#include "client/model/view/colour_scale.h"

#include <algorithm>

#include "client/report/length_text.h"
#include "client/tools/colours.h"

namespace burnish {

namespace {

std::string short_number(double value) {
  return length_text(value, "");
}

ColourScale beta_scale(const SurfaceHit* hit) {
  ColourScale scale{"gradient scale β", "0", "1", "3"};
  if (hit == nullptr) return scale;
  scale.part = hit->mark / 127;
  scale.value = short_number(beta_of_signed_part(scale.part));
  return scale;
}

// The window's κ is times L; a user measures 1/length.
ColourScale curvature_scale(const Document& document, const ColourEnds& ends,
                            const SurfaceHit* hit) {
  const double range = document.curve().kappa_range(), unit = document.length_unit();
  const std::string per = document.unit().empty() ? "" : " 1/" + document.unit();
  const auto text = [&](double part) {
    return short_number(kappa_of_signed_part(part, ends.of(part) * range) / unit) + per;
  };
  ColourScale scale{"curvature", text(-1), "0", text(1)};
  if (hit == nullptr) return scale;
  scale.part = hit->mark / 127;
  scale.value = text(scale.part);
  return scale;
}

ColourScale displacement_scale(const Document& document, const ViewOptions& options,
                               const SurfaceHit* hit) {
  const ColourEnds& ends = options.displacement;
  const double cell = document.cell_size();
  ColourScale scale{"displacement", length_text(-ends.low * cell, document.unit()), "0",
                    length_text(ends.high * cell, document.unit())};
  if (hit == nullptr) return scale;
  scale.part = std::clamp(hit->moved() / (ends.of(hit->moved()) * cell), -1.0, 1.0);
  scale.value = length_text(hit->moved(), document.unit());
  return scale;
}

}  // namespace

std::optional<ColourScale> colour_scale(const Document& document, const Viewport& viewport) {
  const SurfaceHit* const hit = viewport.hover() ? &*viewport.hover() : nullptr;
  switch (document.colour()) {
    case ColourBy::kBeta:
      return beta_scale(hit);
    case ColourBy::kCurvature:
      return curvature_scale(document, viewport.options.curvature, hit);
    case ColourBy::kDisplacement:
      return displacement_scale(document, viewport.options, hit);
    case ColourBy::kNothing:
    case ColourBy::kScan:
      return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace burnish
