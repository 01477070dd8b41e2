#pragma once

#include <meshoptimizer.h>

#include <Eigen/Core>
#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>

#include "tests/common/gltf/glb_file.h"
#include "tests/common/gltf/meshopt_packing.h"

namespace burnish {

/// A mesh that Draco packed, and how it numbers its attributes.
struct DracoData {
  std::string bytes;
  uint32_t position_id = 0;
  uint32_t texture_id = 0;
  uint32_t points = 0;
};

/// The texture coordinates of a position in the tests' packed meshes.
inline Eigen::Vector2f texture_at(const Vec3f& position) {
  return Eigen::Vector2f::Constant(0.5F) + 0.25F * position.head<2>();
}

inline DracoData draco_data(const TriangleMesh& mesh, int method) {
  draco::TriangleSoupMeshBuilder builder;
  builder.Start(static_cast<int>(mesh.triangles.size()));
  const int place = builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
  const int texture =
      builder.AddAttribute(draco::GeometryAttribute::TEX_COORD, 2, draco::DT_FLOAT32);
  for (uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    std::array<Vec3f, 3> corners;
    std::array<Eigen::Vector2f, 3> textures;
    for (size_t c = 0; c < 3; ++c) {
      corners[c] = mesh.vertices[mesh.triangles[t][c]].cast<float>();
      textures[c] = texture_at(corners[c]);
    }
    const draco::FaceIndex face(t);
    builder.SetAttributeValuesForFace(place, face, corners[0].data(), corners[1].data(),
                                      corners[2].data());
    builder.SetAttributeValuesForFace(texture, face, textures[0].data(), textures[1].data(),
                                      textures[2].data());
  }
  const auto packed = builder.Finalize();
  draco::Encoder encoder;
  encoder.SetEncodingMethod(method);
  encoder.SetAttributeQuantization(draco::GeometryAttribute::POSITION, 14);
  encoder.SetAttributeQuantization(draco::GeometryAttribute::TEX_COORD, 12);
  draco::EncoderBuffer buffer;
  EXPECT_TRUE(encoder.EncodeMeshToBuffer(*packed, &buffer).ok());
  return {{buffer.data(), buffer.size()},
          packed->attribute(place)->unique_id(),
          packed->attribute(texture)->unique_id(),
          packed->num_points()};
}

/// Packs a mesh by Draco, as Blender's exporter does.
inline GlbFile draco_glb(const TriangleMesh& mesh, int method) {
  GlbFile file;
  const DracoData data = draco_data(mesh, method);
  const TestJson ids = {{"POSITION", data.position_id}, {"TEXCOORD_0", data.texture_id}};
  const TestJson extension = {{"bufferView", file.add_view(data.bytes)}, {"attributes", ids}};
  file.json["extensionsUsed"] = file.json["extensionsRequired"] = {"KHR_draco_mesh_compression"};
  file.json["accessors"] = {
      {{"componentType", 5126}, {"count", data.points}, {"type", "VEC3"}},
      {{"componentType", 5125}, {"count", 3 * mesh.triangles.size()}, {"type", "SCALAR"}},
      {{"componentType", 5126}, {"count", data.points}, {"type", "VEC2"}}};
  TestJson& primitive = file.add_primitive({{"POSITION", 0}, {"TEXCOORD_0", 2}});
  primitive["indices"] = 1;
  primitive["extensions"] = {{"KHR_draco_mesh_compression", extension}};
  return file;
}

/// Packs a mesh's positions and indices by meshopt, as gltfpack does. `is_version_1`: the positions
/// as KHR_meshopt_compression adds.
inline GlbFile meshopt_glb(const TriangleMesh& mesh, bool is_version_1 = false) {
  GlbFile file;
  const char* name = is_version_1 ? "KHR_meshopt_compression" : "EXT_meshopt_compression";
  std::vector<Vec3f> positions;
  std::vector<uint32_t> indices;
  for (const Vec3d& vertex : mesh.vertices) positions.push_back(vertex.cast<float>());
  for (const Triangle& t : mesh.triangles) indices.insert(indices.end(), t.begin(), t.end());
  file.more_buffers = {{{"byteLength", 12 * mesh.vertices.size() + 12 * mesh.triangles.size()},
                        {"extensions", {{name, {{"fallback", true}}}}}}};
  std::string packed(meshopt_encodeVertexBufferBound(positions.size(), sizeof(Vec3f)), '\0');
  packed.resize(meshopt_encodeVertexBuffer(reinterpret_cast<uint8_t*>(packed.data()), packed.size(),
                                           positions.data(), positions.size(), sizeof(Vec3f)));
  if (is_version_1)
    packed = MeshoptPacking({0, 1, 0x52})
                 .packed({reinterpret_cast<const char*>(positions.data()),
                          positions.size() * sizeof(Vec3f)});
  const auto add = [&](const std::string& bytes, const char* mode, size_t count, size_t stride) {
    const size_t offset = (file.bin.size() + 3) / 4 * 4;
    TestJson extension = {
        {"buffer", 0},          {"byteOffset", offset}, {"byteLength", bytes.size()},
        {"byteStride", stride}, {"mode", mode},         {"count", count}};
    return file.add_view(bytes, {{"buffer", 1},
                                 {"byteOffset", 0},
                                 {"byteLength", count * stride},
                                 {"extensions", {{name, extension}}}});
  };
  const size_t view = add(packed, "ATTRIBUTES", positions.size(), sizeof(Vec3f));
  packed.assign(meshopt_encodeIndexBufferBound(indices.size(), positions.size()), '\0');
  packed.resize(meshopt_encodeIndexBuffer(reinterpret_cast<uint8_t*>(packed.data()), packed.size(),
                                          indices.data(), indices.size()));
  const size_t index_view = add(packed, "TRIANGLES", indices.size(), sizeof(uint32_t));
  file.json["extensionsUsed"] = file.json["extensionsRequired"] = {name};
  const size_t position_accessor = file.add_accessor(view, "VEC3", 5126, positions.size());
  file.add_primitive({{"POSITION", position_accessor}})["indices"] =
      file.add_accessor(index_view, "SCALAR", 5125, indices.size());
  return file;
}

}  // namespace burnish
