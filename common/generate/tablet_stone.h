#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "common/base/types.h"
#include "common/generate/tablet_plan.h"

namespace burnish {

/// A place on the tablet, on a path from the middle of the face to its rim, down the fracture face
/// and around to the underside.
struct StonePlace {
  Eigen::Vector2d towards = {1, 0};  ///< on the boundary of the square [-1, 1]²
  double on_face = 0;                ///< 0 in the middle, 1 at the rim and past it
  double past_rim = 0;               ///< 0 on the face, 1 at the end of the underside
};

/// A broken marble slab of about 600 × 440 × 48 mm: its face is up in the plane z = 0, weathered
/// and engraved; its flanks are fractured.
class TabletStone {
 public:
  explicit TabletStone(uint64_t seed);

  Vec3d point(const StonePlace& place) const;

  /// Returns how deep the letters are cut at p of the face, before hand and weather; nothing away
  /// from the inscription.
  std::optional<double> letter_depth(const Eigen::Vector2d& p) const;

 private:
  Eigen::Vector2d rim_towards(const Eigen::Vector2d& towards) const;
  double fracture(const Vec3d& p) const;
  double face_height(const Eigen::Vector2d& p, double to_rim) const;
  Eigen::Vector2d on_plan(const Eigen::Vector2d& p) const;

  uint64_t seed_;
  std::vector<Eigen::Vector2d> outline_;  ///< counter-clockwise, star-shaped around the origin
  std::vector<Groove> plan_;
};

/// Returns the stone of the tablet that generate_scan() makes from this seed.
TabletStone generated_tablet_stone(uint64_t seed);

}  // namespace burnish
