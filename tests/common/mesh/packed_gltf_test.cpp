#include "common/generate/generate.h"
#include "common/mesh/io/mesh_io.h"
#include "tests/common/gltf/glb_file.h"
#include "tests/common/gltf/packed_glb.h"
#include "tests/common/temporary_folder.h"

namespace burnish {
namespace {

using testing::HasSubstr;

constexpr MeshFormat kPackedGlb = MeshFormat::kGlb;

/// Checks that both meshes have the same triangles in the same order, up to where vertices lie in
/// their arrays.
void expect_same_surface(const TriangleMesh& mesh, const TriangleMesh& expected, double distance) {
  ASSERT_EQ(mesh.triangles.size(), expected.triangles.size());
  EXPECT_EQ(mesh.vertices.size(), expected.vertices.size());
  double area = 0, expected_area = 0;
  const auto area_of = [](const TriangleMesh& m, size_t t) {
    const Vec3d &a = m.vertices[m.triangles[t][0]], &b = m.vertices[m.triangles[t][1]],
                &c = m.vertices[m.triangles[t][2]];
    return (b - a).cross(c - a).norm() / 2;
  };
  for (size_t t = 0; t < mesh.triangles.size(); ++t) {
    area += area_of(mesh, t);
    expected_area += area_of(expected, t);
  }
  EXPECT_NEAR(area, expected_area, 10 * distance * expected_area);
  for (const Vec3d& vertex : mesh.vertices) EXPECT_NEAR(vertex.norm(), 1, distance);
}

TEST(PackedGltf, DracoByEdgebreakerAndInSequenceGiveTheSphere) {
  const TriangleMesh sphere = make_icosphere(3, 1);
  for (const int method : {draco::MESH_EDGEBREAKER_ENCODING, draco::MESH_SEQUENTIAL_ENCODING})
    expect_same_surface(parsed(kPackedGlb, draco_glb(sphere, method).glb()), sphere, 1e-3);
}

TEST(PackedGltf, MeshoptGivesTheSphereExactly) {
  const TriangleMesh sphere = make_icosphere(3, 1);
  const TriangleMesh mesh = parsed(kPackedGlb, meshopt_glb(sphere).glb());
  expect_same_surface(mesh, sphere, 1e-6);
}

TEST(PackedGltf, ReadingMayTakeMoreMemoryForEachOfItsBytes) {
  TemporaryFolder folder;
  const std::string plain = square_glb().glb(), packed = meshopt_glb(make_icosphere(1, 1)).glb();
  const auto bytes_max = [&](const std::string& content, MeshFormat format) {
    return reading_bytes_max(folder.write("scan", content), format).value();
  };
  EXPECT_EQ(bytes_max(plain, MeshFormat::kPly), 12 * plain.size());
  EXPECT_EQ(bytes_max(plain, kPackedGlb), (16u << 20) + 12 * plain.size());
  EXPECT_EQ(bytes_max(packed, kPackedGlb), (16u << 20) + 256 * packed.size());
  EXPECT_EQ(reading_bytes_max(folder / "absent", kPackedGlb).status().code(),
            StatusCode::kNotFound);
}

TEST(PackedGltf, DamagedDracoIsRefusedByThePrimitive) {
  GlbFile file = draco_glb(make_icosphere(1, 1), draco::MESH_EDGEBREAKER_ENCODING);
  file.json["bufferViews"][0]["byteLength"] = 40;
  EXPECT_THAT(refusal(kPackedGlb, file.glb()), HasSubstr("mesh 0, primitive 0: its Draco data"));
  file.bin.assign(file.bin.size(), 'x');
  EXPECT_THAT(refusal(kPackedGlb, file.glb()), HasSubstr("are not a mesh"));
}

TEST(PackedGltf, DracoWithOtherCountsThanItsAccessorsIsRefused) {
  GlbFile file = draco_glb(make_icosphere(1, 1), draco::MESH_EDGEBREAKER_ENCODING);
  file.json["accessors"][0]["count"] = 43;
  EXPECT_THAT(refusal(kPackedGlb, file.glb()), HasSubstr("42 points, but accessor 0 has 43"));
}

TEST(PackedGltf, DamagedMeshoptIsRefusedByTheView) {
  GlbFile file = meshopt_glb(make_icosphere(1, 1));
  const auto refusal_of = [&](const char* member, const TestJson& value) {
    GlbFile changed = file;
    changed.json["bufferViews"][0]["extensions"]["EXT_meshopt_compression"][member] = value;
    return refusal(kPackedGlb, changed.glb());
  };
  EXPECT_THAT(refusal_of("mode", "SPLINES"), HasSubstr("mode 'SPLINES'"));
  EXPECT_THAT(refusal_of("byteStride", 13), HasSubstr("byteStride 13"));
  EXPECT_THAT(refusal_of("count", 1e12), HasSubstr("the limit is 256 times"));
  EXPECT_THAT(refusal_of("filter", "OCTAHEDRAL"), HasSubstr("filter 'OCTAHEDRAL'"));
  file.bin.assign(file.bin.size(), 'x');
  EXPECT_THAT(refusal(kPackedGlb, file.glb()), HasSubstr("meshopt compression is damaged"));
}

TEST(PackedGltf, MeshoptIsReadUnderBothItsNamesAndInBothItsVersions) {
  const TriangleMesh sphere = make_icosphere(3, 1);
  std::string glb = meshopt_glb(sphere).glb();
  for (size_t at = 0; (at = glb.find("EXT_meshopt")) != std::string::npos;)
    glb.replace(at, 3, "KHR");
  expect_same_surface(parsed(kPackedGlb, glb), sphere, 1e-6);
  expect_same_surface(parsed(kPackedGlb, meshopt_glb(sphere, true).glb()), sphere, 1e-6);
}

}  // namespace
}  // namespace burnish
