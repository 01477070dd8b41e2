#pragma once

#include <array>
#include <cstdint>

#include <Eigen/Core>

#include "common/base/status.h"
#include "common/mesh/textures/surface_textures.h"

namespace burnish {

/// Returns the picture that a triangle shows, or kNoTexture: without a material, without a picture,
/// and where a coordinate is missing, not finite or above kTextureCoordinateMax. Needs: a triangle
/// of the textures, whose material is one of them.
uint32_t shown_picture(const SurfaceTextures& textures, uint32_t triangle);

/// Returns where the corners of a triangle lie on its picture: 0 to 1, or beyond where it repeats.
/// Needs: shown_picture().
std::array<Eigen::Vector2d, 3> corners_on_picture(const SurfaceTextures& textures,
                                                  uint32_t triangle);

/// Returns how much of its picture a triangle shows: 1 is all of it, more where it repeats.
/// Needs: shown_picture().
double area_on_picture(const SurfaceTextures& textures, uint32_t triangle);

/// Returns whether a scan without this picture is still a scan. `status`: why it cannot be read.
bool can_be_left_out(const Status& status, const SurfaceTextures& textures);

}  // namespace burnish
