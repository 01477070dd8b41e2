#include "common/generate/generate.h"
#include "common/mesh/io/mesh_io.h"
#include "tests/common/archive/packing.h"
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

uint64_t reading_bytes_of(const std::string& content, MeshFormat format = kPackedGlb) {
  const TemporaryFolder folder;
  return reading_bytes_max(folder.write("scan", content), format).value();
}

constexpr uint64_t kInAnyCase = uint64_t{16} << 20;

TEST(ReadingBytes, AreTwelveForAByteOfAFile) {
  const std::string plain = square_glb().glb();
  EXPECT_EQ(reading_bytes_of(plain, MeshFormat::kPly), 12 * plain.size());
  EXPECT_EQ(reading_bytes_of(plain), kInAnyCase + 12 * plain.size());
  const TemporaryFolder folder;
  EXPECT_EQ(reading_bytes_max(folder / "absent", kPackedGlb).status().code(),
            StatusCode::kNotFound);
}

TEST(ReadingBytes, LeavePicturesOut) {
  GlbFile file = square_glb();
  const uint64_t without = reading_bytes_of(file.glb());
  const size_t view = file.add_view(std::string(1'000'000, 'x'));
  file.json["images"] = {{{"bufferView", view}, {"mimeType", "image/jpeg"}},
                         {{"bufferView", view}, {"mimeType", "image/jpeg"}}};
  EXPECT_LT(reading_bytes_of(file.glb()), without + 12 * 300);  // of more JSON
}

TEST(ReadingBytes, OfAPackedFileAreThoseOfItsNumbers) {
  const TriangleMesh sphere = make_icosphere(5, 1);
  for (const GlbFile& file :
       {meshopt_glb(sphere), draco_glb(sphere, draco::MESH_EDGEBREAKER_ENCODING)}) {
    const std::string packed = file.glb();
    const uint64_t numbers = 12 * sphere.triangles.size() + 32 * sphere.vertices.size();
    EXPECT_LE(reading_bytes_of(packed), kInAnyCase + 12 * (packed.size() + numbers));
    EXPECT_TRUE(read_mesh({reinterpret_cast<const uint8_t*>(packed.data()), packed.size()},
                          kPackedGlb, "scan")
                    .is_ok());
  }
}

TEST(ReadingBytes, OfAPackedFileThatLiesAreAtMost256ForAByte) {
  GlbFile file = meshopt_glb(make_icosphere(1, 1));
  for (TestJson& accessor : file.json["accessors"]) accessor["count"] = uint64_t{1} << 53;
  EXPECT_EQ(reading_bytes_of(file.glb()), kInAnyCase + 256 * file.glb().size());
}

TEST(ReadingBytes, OfAPackedSceneInAnArchiveAreThoseOfItsNumbers) {
  const TriangleMesh sphere = make_icosphere(5, 1);
  GlbFile file = draco_glb(sphere, draco::MESH_EDGEBREAKER_ENCODING);
  file.json["buffers"] = {{{"byteLength", file.bin.size()}, {"uri", "scan.bin"}}};
  const std::string zip =
      as_string(packed({{"scan.gltf", file.json.dump()}, {"scan.bin", file.bin}}));
  EXPECT_GT(reading_bytes_of(zip, MeshFormat::kZip),
            12 * (12 * sphere.triangles.size() + 20 * sphere.vertices.size()));
  EXPECT_EQ(parsed(MeshFormat::kZip, zip).triangles.size(), sphere.triangles.size());
}

TEST(ReadingBytes, OfADamagedFileAreThoseOfAny) {
  std::string damaged = square_glb().glb();
  damaged[20] = '?';
  EXPECT_EQ(reading_bytes_of(damaged), kInAnyCase);
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
  EXPECT_THAT(refusal_of("count", 1e12), HasSubstr("the limit for a file of"));
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
