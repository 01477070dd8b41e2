#include "common/mesh/gltf/glb_writer.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "common/gltf/container.h"
#include "common/mesh/output_buffer.h"
#include "common/mesh/srgb.h"

namespace burnish {

namespace {

/// A mesh's positions as floats around a node's place, which takes what floats cannot.
struct GlbPositions {
  Vec3d node = Vec3d::Zero();
  Vec3f least = Vec3f::Zero();
  Vec3f largest = Vec3f::Zero();

  explicit GlbPositions(const MeshView& mesh) {
    Vec3d low = mesh.vertices.front(), high = low;
    for (const Vec3d& vertex : mesh.vertices) {
      low = low.cwiseMin(vertex);
      high = high.cwiseMax(vertex);
    }
    if (mesh.has_double_positions)
      node = (low / 2 + high / 2).cast<float>().cast<double>() + Vec3d::Zero();
    least = local(low);
    largest = local(high);
  }

  Vec3f local(const Vec3d& position) const { return (position - node).cast<float>(); }
};

template <typename Vector>
std::string json_numbers(const Vector& vector) {
  std::string text = "[";
  for (int axis = 0; axis < 3; ++axis) {
    char digits[32];
    const auto end = std::to_chars(digits, digits + sizeof digits, vector[axis]).ptr;
    text += (axis > 0 ? "," : "") + std::string(digits, end);
  }
  return text + "]";
}

struct GlbSizes {
  uint64_t positions = 0, colours = 0, indices = 0;  // bytes
  uint64_t all() const { return positions + colours + indices; }
};

std::string view_json(uint64_t offset, uint64_t bytes, int target) {
  return R"({"buffer":0,"byteOffset":)" + std::to_string(offset) + R"(,"byteLength":)" +
         std::to_string(bytes) + R"(,"target":)" + std::to_string(target) + "}";
}

/// One node with one mesh of one primitive. A reader of glTF makes flat normals where there are
/// none.
std::string json_of(const MeshView& mesh, const GlbPositions& positions, const GlbSizes& sizes) {
  const std::string vertices = std::to_string(mesh.vertices.size());
  const bool has_node = positions.node != Vec3d::Zero();
  std::string json = R"({"asset":{"version":"2.0","generator":"Burnish"},"scene":0,)";
  json += R"("scenes":[{"nodes":[0]}],"nodes":[{"mesh":0)";
  if (has_node) json += R"(,"translation":)" + json_numbers(positions.node);
  json += R"(}],"meshes":[{"primitives":[{"attributes":{"POSITION":1)";
  json += mesh.has_colours() ? R"(,"COLOR_0":2)" : "";
  json += R"(},"indices":0}]}],"accessors":[{"bufferView":0,"componentType":5125,"count":)";
  json += std::to_string(3 * mesh.triangles.size()) + R"(,"type":"SCALAR"},)";
  json +=
      R"({"bufferView":1,"componentType":5126,"count":)" + vertices + R"(,"type":"VEC3","min":)";
  json += json_numbers(positions.least) + R"(,"max":)" + json_numbers(positions.largest) + "}";
  if (mesh.has_colours())
    json += R"(,{"bufferView":2,"componentType":5123,"normalized":true,"count":)" + vertices +
            R"(,"type":"VEC4"})";
  json += R"(],"bufferViews":[)" + view_json(0, sizes.indices, 34963);
  json += "," + view_json(sizes.indices, sizes.positions, 34962);
  if (mesh.has_colours())
    json += "," + view_json(sizes.indices + sizes.positions, sizes.colours, 34962);
  json += R"(],"buffers":[{"byteLength":)" + std::to_string(sizes.all()) + "}]}";
  return json.append((4 - json.size() % 4) % 4, ' ');
}

void put_colour(const Rgba8& colour, OutputBuffer& output) {
  constexpr float kOne = 65535;
  for (size_t c = 0; c < 3; ++c)
    output.put_bytes(static_cast<uint16_t>(std::lround(kOne * linear_of_srgb(colour[c]))));
  output.put_bytes(static_cast<uint16_t>(257 * colour[3]));
}

}  // namespace

Status write_glb(const MeshView& mesh, OutputBuffer& output) {
  const GlbPositions positions(mesh);
  GlbSizes sizes{.positions = mesh.vertices.size() * sizeof(Vec3f),
                 .indices = mesh.triangles.size() * sizeof(Triangle)};
  if (mesh.has_colours()) sizes.colours = mesh.vertices.size() * 4 * sizeof(uint16_t);
  const std::string json = json_of(mesh, positions, sizes);
  const uint64_t bytes = kGlbHeaderBytes + 2 * kGlbChunkHeaderBytes + json.size() + sizes.all();
  if (bytes > UINT32_MAX)
    return invalid_argument("a GLB file of " + std::to_string(bytes) + " bytes: the limit is " +
                            std::to_string(UINT32_MAX));
  for (const uint64_t word :
       {uint64_t{kGlbMagic}, uint64_t{2}, bytes, uint64_t{json.size()}, uint64_t{kGlbJsonChunk}})
    output.put_bytes(static_cast<uint32_t>(word));
  output.put_text(json);
  output.put_bytes(static_cast<uint32_t>(sizes.all()));
  output.put_bytes(kGlbBinChunk);
  for (const Triangle& triangle : mesh.triangles) output.put_bytes(triangle);
  for (const Vec3d& vertex : mesh.vertices) {
    const Vec3f position = positions.local(vertex);
    output.put_bytes(position);
  }
  for (const Rgba8& colour : mesh.colours) put_colour(colour, output);
  return output.flush();
}

}  // namespace burnish
