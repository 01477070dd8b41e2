#include "common/wire/format_wire.h"

#include "common/base/limits.h"
#include "common/base/text.h"
#include "common/transfer/chunk.h"

namespace burnish {

v1::MeshFormat to_wire(MeshFormat format) {
  switch (format) {
    case MeshFormat::kPly:
      return v1::MESH_FORMAT_PLY;
    case MeshFormat::kObj:
      return v1::MESH_FORMAT_OBJ;
    case MeshFormat::kStl:
      return v1::MESH_FORMAT_STL;
    case MeshFormat::kOff:
      return v1::MESH_FORMAT_OFF;
    case MeshFormat::kGlb:
      return v1::MESH_FORMAT_GLB;
    case MeshFormat::kGltf:
      return v1::MESH_FORMAT_GLTF;
    case MeshFormat::kZip:
      return v1::MESH_FORMAT_ZIP;
  }
  return v1::MESH_FORMAT_UNSPECIFIED;
}

Result<MeshFormat> from_wire(v1::MeshFormat format) {
  switch (format) {
    case v1::MESH_FORMAT_PLY:
      return MeshFormat::kPly;
    case v1::MESH_FORMAT_OBJ:
      return MeshFormat::kObj;
    case v1::MESH_FORMAT_STL:
      return MeshFormat::kStl;
    case v1::MESH_FORMAT_OFF:
      return MeshFormat::kOff;
    case v1::MESH_FORMAT_GLB:
      return MeshFormat::kGlb;
    case v1::MESH_FORMAT_GLTF:
      return MeshFormat::kGltf;
    case v1::MESH_FORMAT_ZIP:
      return MeshFormat::kZip;
    default:
      break;
  }
  return invalid_argument("mesh format " + std::to_string(static_cast<int>(format)) +
                          " is outside 1 (PLY) to 7 (GLTF)");
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
