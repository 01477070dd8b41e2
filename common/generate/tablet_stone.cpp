#include "common/generate/tablet_stone.h"

#include <algorithm>
#include <cmath>

#include "common/generate/noise.h"

namespace burnish {
namespace {

using Vec2d = Eigen::Vector2d;

constexpr double kThickness = 48;  // millimetres, like every length here
constexpr double kUnderside = 26;  // how far the scan sees around the lower edge

/// One noise for each feature of the stone.
enum Feature : uint64_t {
  kOutline,
  kBreak,
  kSplinters,
  kUndulation,
  kGrain,
  kPits,
  kFlakes,
  kFlakeFloor,
  kChips,
  kWear,
  kUndercut
};

double smooth_step(double from, double to, double x) {
  const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

/// Maps the square [-1, 1]² to the whole slab.
Vec2d slab_point(const Vec2d& p) {
  return {300 * p.x(), 220 * p.y()};
}

Vec3d flat(const Vec2d& p) {
  return {p.x(), p.y(), 0};
}

}  // namespace

TabletStone::TabletStone(uint64_t seed) : seed_(seed), plan_(tablet_plan()) {
  constexpr double kOutlineJitter = 34;
  outline_ = {{296, -58},   {268, 60},   {308, 128}, {176, 214},  {24, 192},
              {-158, 226},  {-262, 150}, {-304, 60}, {-258, -52}, {-292, -186},
              {-110, -228}, {44, -190},  {190, -222}};
  for (size_t i = 0; i < outline_.size(); ++i)
    outline_[i] += kOutlineJitter * Vec2d(uniform(sub_seed(seed, kOutline), 2 * i) - 0.5,
                                          uniform(sub_seed(seed, kOutline), 2 * i + 1) - 0.5);
}

/// Returns the point where the ray from the origin meets the outline.
Vec2d TabletStone::rim_towards(const Vec2d& towards) const {
  const auto cross = [](const Vec2d& u, const Vec2d& v) { return u.x() * v.y() - u.y() * v.x(); };
  const Vec2d ray = slab_point(towards);
  for (size_t i = 0; i < outline_.size(); ++i) {
    const Vec2d &a = outline_[i], &b = outline_[(i + 1) % outline_.size()];
    if (cross(a, ray) >= 0 && cross(ray, b) > 0) return ray * (cross(a, b - a) / cross(ray, b - a));
  }
  return ray;  // not reached: the outline is closed around the origin
}

/// Spreads points evenly around the middle and bends them to the rim only near it, so that the
/// corners of the outline do not crease the sampling of the whole face.
static Vec2d face_point(const StonePlace& place, const Vec2d& rim) {
  constexpr double kMeanReach = 0.95;  // of the slab
  const double t = place.on_face;
  const Vec2d even = kMeanReach * slab_point(place.towards);
  return t * (even + t * t * (rim - even));
}

/// Returns how far the fracture face stands out of the straight outline.
double TabletStone::fracture(const Vec3d& p) const {
  const double broken = 22 * fractal_noise(p / 75, 6, sub_seed(seed_, kBreak));
  const double splinters = 7 * std::abs(gradient_noise(p / 26, sub_seed(seed_, kSplinters)));
  return broken - splinters;
}

/// Turns p to the axes of the plan, which are not the fragment's.
Vec2d TabletStone::on_plan(const Vec2d& p) const {
  constexpr double kCosine = 0.9928, kSine = 0.1198;
  return {kCosine * p.x() + kSine * p.y(), kCosine * p.y() - kSine * p.x()};
}

std::optional<double> TabletStone::letter_depth(const Vec2d& p) const {
  const Vec2d at = on_plan(p);
  if (!inscription_box().contains(at)) return std::nullopt;
  return groove_depth(plan_, at);
}

double TabletStone::face_height(const Vec2d& p, double to_rim) const {
  const auto noise = [&](double wavelength, int octaves, Feature feature) {
    return fractal_noise(flat(p) / wavelength, octaves, sub_seed(seed_, feature));
  };
  const double undulation = 1.6 * noise(140, 2, kUndulation) + 0.25 * noise(9, 3, kGrain);
  const double pits = 2.2 * std::max(0.0, noise(7, 1, kPits) - 0.38);
  const Vec2d hand_held(0.9 * noise(24, 1, kWear), 0.9 * noise(24, 1, kChips));
  const double cut = groove_depth(plan_, on_plan(p + hand_held)) * (1 + 0.5 * noise(40, 1, kWear));
  const double flaked = smooth_step(0.25, 0.32, noise(150, 5, kFlakes));
  const double flake = flaked * (2.6 + 1.6 * noise(22, 4, kFlakeFloor));
  const double chip_reach = 9 + 30 * std::max(0.0, noise(45, 3, kChips));
  const double near_rim = std::max(0.0, 1 - to_rim / chip_reach);
  const double chip = 0.3 * chip_reach * near_rim * near_rim;
  return undulation - pits - std::max(cut, flake) - chip;
}

Vec3d TabletStone::point(const StonePlace& place) const {
  const Vec2d straight_rim = rim_towards(place.towards);
  const Vec2d outward = straight_rim.normalized();
  const double rim_shift = fracture(flat(straight_rim));
  const double rim_weight = smooth_step(0.75, 1, place.on_face);
  const Vec2d on_face = face_point(place, straight_rim) + rim_weight * rim_shift * outward;
  const double to_rim = (1 - place.on_face) * straight_rim.norm();
  const double height = face_height(on_face, to_rim);
  if (place.past_rim <= 0) return flat(on_face) + Vec3d(0, 0, height);

  const double path = place.past_rim * (kThickness + kUnderside);
  const double down = std::min(path / kThickness, 1.0);
  const double under = std::max(path - kThickness, 0.0);
  const Vec3d on_flank = flat(straight_rim) - Vec3d(0, 0, down * kThickness);
  const double shift = fracture(on_flank) - under;
  const double undercut = 5 * fractal_noise(on_flank / 30, 3, sub_seed(seed_, kUndercut));
  const double z = (1 - down) * height - down * (kThickness + undercut);
  const Vec2d p = straight_rim + shift * outward;
  return {p.x(), p.y(), z};
}

}  // namespace burnish
