#include "common/wire/format_wire.h"

#include "common/base/limits.h"
#include "common/base/text.h"
#include "common/transfer/chunk.h"

namespace burnish {

v1::MeshFormat to_wire(MeshFormat format) {
  return static_cast<v1::MeshFormat>(format);
}

Result<MeshFormat> from_wire(v1::MeshFormat format) {
  for (const MeshFormatFacts& known : kMeshFormats)
    if (to_wire(known.format) == format) return known.format;
  return invalid_argument("mesh format " + std::to_string(static_cast<int>(format)) +
                          " is none of 1 to " + std::to_string(kMeshFormats.size()));
}

void set_chunk(uint64_t offset, std::string_view piece, v1::Chunk& chunk) {
  chunk.set_offset(offset);
  chunk.set_data(piece.data(), piece.size());
  chunk.set_crc32(chunk_crc32(piece));
}

v1::Point to_wire(const Vec3d& point) {
  v1::Point message;
  message.set_x(point.x());
  message.set_y(point.y());
  message.set_z(point.z());
  return message;
}

Vec3d from_wire(const v1::Point& point) {
  return {point.x(), point.y(), point.z()};
}

v1::ThinWalls to_wire(const ThinWalls& walls) {
  v1::ThinWalls message;
  message.set_share(walls.share);
  message.set_depth(walls.depth);
  return message;
}

ThinWalls from_wire(const v1::ThinWalls& message) {
  return {message.share(), message.depth()};
}

Result<PreparedKey> prepared_key_from_wire(int depth, double curvature_radius) {
  if (depth != 0 && (depth < kDepthMin || depth > kDepthMax))
    return invalid_argument("depth " + std::to_string(depth) + " is outside " +
                            std::to_string(kDepthMin) + ".." + std::to_string(kDepthMax) +
                            " and not 0 (chosen by the server)");
  if (!(curvature_radius >= 0 && curvature_radius <= kCurvatureRadiusMax))
    return invalid_argument("curvature radius " + shortest_text(curvature_radius) +
                            " is outside 0.." + shortest_text(kCurvatureRadiusMax) +
                            " of sqrt(area)");
  return PreparedKey{depth, curvature_radius < kCurvatureRadiusMin ? 0.0 : curvature_radius};
}

}  // namespace burnish
