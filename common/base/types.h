#pragma once

#include <array>
#include <cstdint>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace burnish {

using Vec3f = Eigen::Vector3f;
using Vec3d = Eigen::Vector3d;
using Vec3i = Eigen::Vector3i;

/// Vertex indices of one triangle, counter-clockwise seen from outside.
using Triangle = std::array<uint32_t, 3>;

/// A colour: red, green, blue and alpha, as a screen takes them (sRGB).
using Rgba8 = std::array<uint8_t, 4>;

}  // namespace burnish
