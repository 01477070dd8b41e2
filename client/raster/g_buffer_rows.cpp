#include "client/raster/g_buffer_rows.h"

#include <cmath>

namespace burnish {
namespace {

struct Turn {
  float right, up;
};

/// Lights one pixel after the other.
class SurroundingLight {
 public:
  SurroundingLight(const GBufferPlaces& places, const Occlusions& occlusions,
                   const Lighting& lighting)
      : places_(places), occlusions_(occlusions), lighting_(lighting) {}

  // Multiplies the colour in sRGB.
  float factor(const GBufferPlace& place, int x, int up, int sample) const {
    if (place.away == 0) return 1;
    const GBufferCentre at(places_, place);
    float light = 1;
    if (lighting_.kind == LightKind::kRadiance)
      light = radiance_scaling(std::tanh(1.2f * curvature(at, x, up, sample)), place.strength);
    if (lighting_.kind == LightKind::kCavity) light = cavity(curvature(at, x, up, sample));
    if (lighting_.occlusion > 0)
      light *= 1 - static_cast<float>(lighting_.occlusion) * occlusion_at(at, x, up);
    return mixed(1.0f, power(greater(light, 0), 1 / shade::kGamma), place.part);
  }

  bool is_one_surface(int x, int up, const GBufferPlace& first) const {
    const GBufferCentre centre(places_, first);
    for (int i = 1; i < places_.samples(); ++i) {
      float away = 0;
      const ShadeVector other = places_.position(x, up, i, away);
      if ((away == 0) != (first.away == 0)) return false;
      if (first.away > 0 && centre.off_plane(other) > 4) return false;
    }
    return true;
  }

 private:
  static Turn turn_to(const GBufferCentre& at, const GBufferPlace& other, float distance) {
    if (other.away == 0) return {0, 0};
    const float near = clamped(2 - at.off_plane(other.position) / (1.5f * distance + 1));
    const ShadeVector turn = other.n - at.n;
    return {near * dot(turn, at.right), near * dot(turn, at.up)};
  }

  float curvature(const GBufferCentre& at, int x, int up, int sample) const {
    float sum = 0;
    for (const float wanted : {1.0f, 3.0f, 8.0f}) {
      const int reach =
          std::max(static_cast<int>(wanted * static_cast<float>(places_.height()) / 900 + 0.5f), 1);
      const auto by = [&](int right, int above) {
        return turn_to(at, places_.at(x + right, up + above, sample), static_cast<float>(reach));
      };
      sum += by(reach, 0).right - by(-reach, 0).right;
      sum += by(0, reach).up - by(0, -reach).up;
    }
    return sum * smooth_step(0.05f, 0.45f, at.facing);
  }

  // Vergne et al. 2010, equation 3.
  float radiance_scaling(float bend, float light) const {
    constexpr float kInvariant = 0.12f;
    const float up = std::exp(-static_cast<float>(lighting_.radiance) * bend);
    return (kInvariant * up + light * (1 - kInvariant * (1 + up))) /
           (kInvariant + light * (up - kInvariant * (1 + up)));
  }

  float cavity(float bend) const {
    const float size = std::abs(bend) / (1 + 1.5f * std::abs(bend));
    const auto ridge = static_cast<float>(lighting_.ridge);
    const auto valley = static_cast<float>(lighting_.valley);
    return greater(1 + (bend > 0 ? 0.9f * ridge : -1.2f * valley) * size, 0.05f);
  }

  float occlusion_at(const GBufferCentre& at, int x, int up) const {
    float sum = 0, weights = 1e-4f;
    for (int dy = -2; dy < 2; ++dy)
      for (int dx = -2; dx < 2; ++dx) {
        float away = 0;
        const ShadeVector other = places_.position(x + dx, up + dy, 0, away);
        if (away == 0) continue;
        const float weight = clamped(2 - at.off_plane(other) / 3);
        const size_t pixel = places_.number(x + dx, up + dy, 0) / places_.samples();
        sum += weight * static_cast<float>(occlusions_[pixel]) / 255;
        weights += weight;
      }
    return sum / weights;
  }

  const GBufferPlaces& places_;
  const Occlusions& occlusions_;
  const Lighting& lighting_;
};

}  // namespace

void light_g_buffer(const GBufferPlaces& places, const GBuffer& g_buffer,
                    const Occlusions& occlusions, const Lighting& lighting, const RowRange& rows,
                    Image& image) {
  const SurroundingLight light(places, occlusions, lighting);
  const int samples = places.samples();
  for (int row = rows.first; row < rows.end; ++row)
    for (int x = 0; x < places.width(); ++x) {
      const int up = places.height() - 1 - row;
      const GBufferPlace first = places.at(x, up, 0);
      const bool once = light.is_one_surface(x, up, first);
      float factor = light.factor(first, x, up, 0);
      std::array<float, 3> sum{};
      for (int s = 0; s < samples; ++s) {
        if (!once && s > 0) factor = light.factor(places.at(x, up, s), x, up, s);
        const GBufferSample& geometry = g_buffer[places.number(x, up, s)];
        for (int c = 0; c < 3; ++c)
          sum[c] += lesser(factor * static_cast<float>(geometry.colour[c]), 255);
      }
      uint8_t* const to = image.rgb.data() + 3 * (size_t(row) * places.width() + x);
      for (int c = 0; c < 3; ++c)
        to[c] = static_cast<uint8_t>(sum[c] / static_cast<float>(samples) + 0.5f);
    }
}

}  // namespace burnish
