#pragma once

#include <algorithm>

#include "client/raster/page_projection.h"
#include "client/raster/sample_reliefs.h"
#include "client/raster/shade_math.h"
#include "client/raster/visibility.h"

namespace burnish {

/// What a sample shows, in camera space.
struct ReliefPlace {
  ShadeVector n{0, 0, 1};
  float away = 0;  ///< distance along the view; 0: nothing is there
  ShadeVector position{0, 0, 0};
  float strength = 0;  ///< of the light, 0 to 1
  float part = 0;      ///< of the surface in the colour
};

/// The samples around a pixel. Formulas are those of kReliefParts in client/gl/relief_shader.cpp,
/// and rows run up, as there.
class ReliefPlaces {
 public:
  ReliefPlaces(const PageProjection& projection, const Visibility& visibility,
               const SampleReliefs& reliefs)
      : projection_(projection), visibility_(visibility), reliefs_(reliefs) {}

  int width() const { return visibility_.size.width; }
  int height() const { return visibility_.size.height; }
  int samples() const { return visibility_.samples; }
  const PageProjection& projection() const { return projection_; }

  /// Returns the number of a sample; pixels past the border are those at the border.
  size_t number(int x, int up, int sample) const {
    const int column = std::clamp(x, 0, width() - 1), row = std::clamp(up, 0, height() - 1);
    return visibility_.place(column, height() - 1 - row) + sample;
  }

  ReliefPlace at(int x, int up, int sample) const;
  ShadeVector to_eye_from(const ReliefPlace& at) const {
    return projection_.is_parallel ? ShadeVector{0, 0, 1} : unit(-1.0f * at.position);
  }
  float pixel_length(const ReliefPlace& at) const {
    return 2 * projection_.half_view.y() / static_cast<float>(height()) *
           (projection_.is_parallel ? 1.0f : at.away);
  }
  /// Returns how far another place lies from the plane of this one, in pixels.
  float off_plane(const ReliefPlace& at, const ReliefPlace& other) const {
    const float facing = greater(dot(at.n, to_eye_from(at)), 0.2f);
    return __builtin_fabsf(dot(at.n, other.position - at.position)) / (facing * pixel_length(at));
  }

 private:
  const PageProjection& projection_;
  const Visibility& visibility_;
  const SampleReliefs& reliefs_;
};

inline ReliefPlace ReliefPlaces::at(int x, int up, int sample) const {
  const size_t sample_number = number(x, up, sample);
  const SampleKey key = visibility_.keys[sample_number];
  if (key == kNothingSeen) return {};
  const SampleRelief& relief = reliefs_[sample_number];
  const float nearness = nearness_of_key(key);
  const Eigen::Vector4f& terms = projection_.depth_terms;
  const float away = (terms.x() + terms.y() * nearness) / (terms.z() + terms.w() * nearness);
  const float scale = projection_.is_parallel ? 1.0f : away;
  const float column = static_cast<float>(std::clamp(x, 0, width() - 1)) + 0.5f;
  const float row = static_cast<float>(std::clamp(up, 0, height() - 1)) + 0.5f;
  const float across =
      (2 * column / static_cast<float>(width()) - 1) * projection_.half_view.x() * scale;
  const float above =
      (2 * row / static_cast<float>(height()) - 1) * projection_.half_view.y() * scale;
  return {unit({float(relief.normal[0]), float(relief.normal[1]), float(relief.normal[2])}),
          away,
          {across, above, -away},
          static_cast<float>(relief.strength) / 65535,
          static_cast<float>(relief.part) / 65535};
}

}  // namespace burnish
