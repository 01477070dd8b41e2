#pragma once

#include <string_view>
#include <vector>

#include <Eigen/Core>

namespace burnish {

using Polyline = std::vector<Eigen::Vector2d>;

/// Draws the right half of a circle from below to above; without libm, see noise.h.
Polyline half_circle(const Eigen::Vector2d& centre, double radius, int pieces);

/// Returns the strokes of a text in capitals of this height, from `at` on its base line, with `gap`
/// times the height between letters. Knows only the letters of the inscriptions:
/// A C E H I M O P Q R S X.
std::vector<Polyline> strokes_of(std::string_view text, Eigen::Vector2d at, double height,
                                 double gap);

/// Returns the distance of p from the segment from a to b, which may be a point.
double distance_to_segment(const Eigen::Vector2d& p, const Eigen::Vector2d& a,
                           const Eigen::Vector2d& b);

}  // namespace burnish
