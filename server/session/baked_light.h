#pragma once

#include <span>
#include <vector>

#include "server/solver/cycle/multigrid.h"

namespace burnish {

/// One number at a corner, as evaluate() takes it.
using CornerNumber = Eigen::Matrix<float, 1, 1>;

/// No colour becomes more than so many times as bright or as dark where its light goes.
inline constexpr float kLightFactorMax = 4;

/// Finds the light that was there when a scan's colours were taken: the polynomial of second degree
/// in normal and place that is nearest to the logarithm of the colours' luminance, by area. Returns
/// the logarithm of what takes it away: of its mean over it, one for all three channels. It is as
/// smooth as the normals, so patterns of the colours stay.
/// Shapes: the colours' trilinear fit, one per corner of the finest depth; returns one per corner.
/// Source: the irradiance of a convex surface is nearly of second degree in its normal (Ramamoorthi
/// and Hanrahan, "An efficient representation for irradiance environment maps", 2001).
/// Needs: a scan with triangles. The same bits for any number of threads.
std::vector<CornerNumber> find_baked_light(const Multigrid& on, std::span<const Vec3f> fitted);

/// Returns the bytes that it takes at most, with the fit and its result.
uint64_t predict_light_bytes(const Multigrid& on);

}  // namespace burnish
