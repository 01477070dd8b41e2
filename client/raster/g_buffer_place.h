#pragma once

#include <algorithm>

#include "client/raster/g_buffer.h"
#include "client/raster/page_projection.h"
#include "client/raster/shade_math.h"
#include "client/raster/visibility.h"

namespace burnish {

/// Describes the surface that a sample shows, in camera space.
struct GBufferPlace {
  ShadeVector n{0, 0, 1};
  float away = 0;  ///< distance along the view; 0: nothing is there
  ShadeVector position{0, 0, 0};
  float strength = 0;  ///< of the light, 0 to 1
  float part = 0;      ///< of the surface in the colour
};

/// The samples around a pixel. Formulas are those of kGBufferParts in
/// client/gl/g_buffer_shader.cpp, and rows run up, as there.
class GBufferPlaces {
 public:
  GBufferPlaces(const PageProjection& projection, const Visibility& visibility,
                const GBuffer& g_buffer)
      : projection_(projection),
        visibility_(visibility),
        g_buffer_(g_buffer),
        across_(2 * projection.half_view.x() / static_cast<float>(visibility.size.width),
                2 * projection.half_view.y() / static_cast<float>(visibility.size.height)) {}

  int width() const { return visibility_.size.width; }
  int height() const { return visibility_.size.height; }
  int samples() const { return visibility_.samples; }
  const PageProjection& projection() const { return projection_; }

  /// Returns the number of a sample; pixels past the border are those at the border.
  size_t number(int x, int up, int sample) const {
    const int column = std::clamp(x, 0, width() - 1), row = std::clamp(up, 0, height() - 1);
    return visibility_.place(column, height() - 1 - row) + sample;
  }

  GBufferPlace at(int x, int up, int sample) const;

  /// Returns where a sample is, and how far away along the view: 0 if nothing is there.
  ShadeVector position(int x, int up, int sample, float& away) const;

  float pixel_length(const GBufferPlace& at) const {
    return across_.y() * (projection_.is_parallel ? 1.0f : at.away);
  }

 private:
  const PageProjection& projection_;
  const Visibility& visibility_;
  const GBuffer& g_buffer_;
  Eigen::Vector2f across_;  // a pixel at distance 1
};

inline ShadeVector GBufferPlaces::position(int x, int up, int sample, float& away) const {
  const SampleKey key = visibility_.keys[number(x, up, sample)];
  away = 0;
  if (key == kNothingSeen) return {0, 0, 0};
  const float nearness = nearness_of_key(key);
  const Eigen::Vector4f& terms = projection_.depth_terms;
  away = (terms.x() + terms.y() * nearness) / (terms.z() + terms.w() * nearness);
  const float scale = projection_.is_parallel ? 1.0f : away;
  const float column = static_cast<float>(std::clamp(x, 0, width() - 1)) + 0.5f;
  const float row = static_cast<float>(std::clamp(up, 0, height() - 1)) + 0.5f;
  return {(column * across_.x() - projection_.half_view.x()) * scale,
          (row * across_.y() - projection_.half_view.y()) * scale, -away};
}

inline GBufferPlace GBufferPlaces::at(int x, int up, int sample) const {
  constexpr float kPerNormalStep = 1.0f / 32767, kPerStep = 1.0f / 65535;
  GBufferPlace place;
  place.position = position(x, up, sample, place.away);
  if (place.away == 0) return place;
  const GBufferSample& geometry = g_buffer_[number(x, up, sample)];
  place.n = kPerNormalStep * ShadeVector{float(geometry.normal[0]), float(geometry.normal[1]),
                                         float(geometry.normal[2])};
  place.strength = kPerStep * static_cast<float>(geometry.strength);
  place.part = kPerStep * static_cast<float>(geometry.part);
  return place;
}

/// A place with what the places around it are compared with.
struct GBufferCentre {
  GBufferCentre(const GBufferPlaces& places, const GBufferPlace& place)
      : n(place.n),
        position(place.position),
        to_eye(places.projection().is_parallel ? ShadeVector{0, 0, 1}
                                               : unit(-1.0f * place.position)),
        right(unit(cross({0, 1, 0}, to_eye))),
        up(cross(to_eye, right)),
        facing(dot(place.n, to_eye)),
        pixels_off(1 / (greater(facing, 0.2f) * places.pixel_length(place))) {}

  /// Returns how far another place lies from the plane of this one, in pixels.
  float off_plane(ShadeVector other) const {
    return __builtin_fabsf(dot(n, other - position)) * pixels_off;
  }

  ShadeVector n, position;
  ShadeVector to_eye, right, up;  ///< the frame of the eye's ray
  float facing;                   ///< cosine of the normal to the eye
  float pixels_off;               ///< per unit of distance from the plane
};

}  // namespace burnish
