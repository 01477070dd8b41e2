#pragma once

#include <string_view>

#include "burnish/v1/common.pb.h"
#include "common/base/types.h"
#include "common/mesh/mesh_format.h"
#include "common/mesh/statistics/thin_walls.h"
#include "common/service/scan_info.h"

namespace burnish {

v1::MeshFormat to_wire(MeshFormat format);

/// Fails: invalid_argument for an unspecified or unknown format.
Result<MeshFormat> from_wire(v1::MeshFormat format);

/// A piece of a file with its checksum.
void set_chunk(uint64_t offset, std::string_view piece, v1::Chunk& chunk);

v1::Point to_wire(const Vec3d& point);
Vec3d from_wire(const v1::Point& point);

v1::ThinWalls to_wire(const ThinWalls& walls);
ThinWalls from_wire(const v1::ThinWalls& message);

/// A depth (0 allowed) and an averaging radius as they come in a request; a radius below
/// kCurvatureRadiusMin averages nothing and counts as 0.
/// Fails: invalid_argument naming the value and its limits.
Result<PreparedKey> prepared_key_from_wire(int depth, double curvature_radius);
inline Result<PreparedKey> prepared_key_from_wire(const PreparedKey& key) {
  return prepared_key_from_wire(key.depth, key.curvature_radius);
}

}  // namespace burnish
