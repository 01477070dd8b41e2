#include "common/mesh/gltf/gltf_surface.h"

#include <cmath>
#include <numbers>

#include "tests/common/gltf/glb_file.h"

namespace burnish {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr MeshFormat kGlb = MeshFormat::kGlb;

const std::vector<Vec3d> kSquareVertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};

/// Replaces a number of a file's JSON, by its pointer, and returns the refusal.
std::string refusal_with(GlbFile file, const char* pointer, const TestJson& value) {
  file.json[TestJson::json_pointer(pointer)] = value;
  return refusal(kGlb, file.glb());
}

TEST(GltfSurface, ABinaryFileAndATextGiveTheSameSquare) {
  const GlbFile file = square_glb();
  for (const std::string& content : {file.glb(), file.gltf(), file.gltf(2)}) {
    const TriangleMesh mesh = parsed(kGlb, content);
    EXPECT_EQ(mesh.vertices, kSquareVertices);
    EXPECT_THAT(mesh.triangles, ElementsAre(Triangle{0, 1, 2}, Triangle{0, 2, 3}));
    EXPECT_FALSE(mesh.has_colours());
    EXPECT_FALSE(mesh.has_double_positions);
  }
}

TEST(GltfSurface, APrimitiveWithoutIndicesIsWeldedAsTrimeshWritesSoups) {
  GlbFile file;
  file.add_primitive({{"POSITION", file.add_floats("VEC3", 6,
                                                   {0, 0, 0, 1, 0, 0, 1, 1, 0,  //
                                                    0, 0, -0.F, 1, 1, 0, 0, 1, 0})}});
  const TriangleMesh mesh = parsed(kGlb, file.glb());
  EXPECT_EQ(mesh.vertices, kSquareVertices);
  EXPECT_THAT(mesh.triangles, ElementsAre(Triangle{0, 1, 2}, Triangle{0, 2, 3}));
}

TEST(GltfSurface, InterleavedPositionsAreReadByTheirStride) {
  GlbFile file;
  std::string bytes;
  for (const Vec3d& p : kSquareVertices)
    bytes += bytes_of(0.F, 0.F, 1.F) + bytes_of(Vec3f(p.cast<float>()));
  const size_t view = file.add_view(bytes, {{"byteStride", 24}, {"target", 34962}});
  const size_t normals = file.add_accessor(view, "VEC3", 5126, 4);
  const size_t positions = file.add_accessor(view, "VEC3", 5126, 4, {{"byteOffset", 12}});
  file.add_primitive({{"NORMAL", normals}, {"POSITION", positions}})["indices"] =
      file.add_indices({0, 1, 2, 0, 2, 3});
  EXPECT_EQ(parsed(kGlb, file.glb()).vertices, kSquareVertices);
}

TEST(GltfSurface, StripsAndFansAreTrianglesAndPointsAndLinesAreNot) {
  for (const auto& [mode, corners] : {std::pair(5, std::vector<uint16_t>{0, 1, 3, 2}),
                                      std::pair(6, std::vector<uint16_t>{0, 1, 2, 3})}) {
    GlbFile file;
    TestJson attributes = {{"POSITION", file.add_floats("VEC3", 4, kSquareFloats)}};
    file.add_primitive(attributes) = {
        {"attributes", attributes}, {"indices", file.add_indices(corners)}, {"mode", mode}};
    for (const int other : {0, 1, 2, 3}) file.add_primitive(attributes)["mode"] = other;
    const TriangleMesh mesh = parsed(kGlb, file.glb());
    ASSERT_EQ(mesh.triangles.size(), 2u);
    for (const Triangle& t : mesh.triangles) {
      const Vec3d a = mesh.vertices[t[0]], b = mesh.vertices[t[1]], c = mesh.vertices[t[2]];
      EXPECT_EQ((b - a).cross(c - a), Vec3d(0, 0, 1)) << mode;
    }
  }
}

TEST(GltfSurface, NodesPlaceTheirMeshesInTheScene) {
  GlbFile file = square_glb();
  const double half = std::numbers::sqrt2 / 2;
  file.json["nodes"] = {
      {{"children", {1, 2}}, {"translation", {10, 0, 0}}},
      {{"mesh", 0}, {"rotation", {0, 0, half, half}}, {"scale", {2, 2, 2}}},
      {{"mesh", 0}, {"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 5, 1}}}};
  const TriangleMesh mesh = parsed(kGlb, file.glb());
  ASSERT_EQ(mesh.vertices.size(), 8u);
  EXPECT_LT((mesh.vertices[1] - Vec3d(10, 2, 0)).norm(), 1e-12);
  EXPECT_EQ(mesh.vertices[6], Vec3d(11, 1, 5));
  EXPECT_EQ(mesh.triangles.size(), 4u);
}

TEST(GltfSurface, AMirroringNodeTurnsItsTrianglesSoThatTheyFaceOutwards) {
  GlbFile file = square_glb();
  file.json["nodes"][0]["scale"] = {-1, 1, 1};
  const TriangleMesh mesh = parsed(kGlb, file.glb());
  const Triangle& t = mesh.triangles[0];
  const Vec3d a = mesh.vertices[t[0]], b = mesh.vertices[t[1]], c = mesh.vertices[t[2]];
  EXPECT_EQ((b - a).cross(c - a), Vec3d(0, 0, 1));
}

TEST(GltfSurface, MeshesOfDifferentNodesAreWeldedWhereTheyTouch) {
  GlbFile file = square_glb();
  file.json["nodes"].push_back({{"mesh", 0}, {"translation", {1, 0, 0}}});
  file.json["scenes"][0]["nodes"] = {0, 1};
  EXPECT_EQ(parsed(kGlb, file.glb()).vertices.size(), 6u);
}

TEST(GltfSurface, WithoutScenesAllRootsArePlaced) {
  GlbFile file = square_glb();
  file.json.erase("scene");
  file.json.erase("scenes");
  file.json["nodes"] = {{{"mesh", 0}}, {{"children", {0}}, {"translation", {0, 0, 3}}}};
  EXPECT_EQ(parsed(kGlb, file.glb()).vertices[0], Vec3d(0, 0, 3));
}

TEST(GltfSurface, ALargeTranslationKeepsDoubles) {
  GlbFile file = square_glb();
  file.json["nodes"][0]["translation"] = {4512345.678, 0, 0};
  const TriangleMesh mesh = parsed(kGlb, file.glb());
  EXPECT_TRUE(mesh.has_double_positions);
  EXPECT_EQ(mesh.vertices[0].x(), 4512345.678);
}

TEST(GltfSurface, LinearColoursBecomeSrgbBytes) {
  GlbFile file = square_glb();
  file.json["meshes"][0]["primitives"][0]["attributes"]["COLOR_0"] = file.add_floats(
      "VEC4", 4, {0, 1, 0.5F, 1, 0.25F, 0, 0, 0.5F, 2, -1, 0, 1, NAN, 0, 0.002F, 1});
  EXPECT_THAT(parsed(kGlb, file.glb()).colours,
              ElementsAre(Rgba8{0, 255, 188, 255}, Rgba8{137, 0, 0, 128}, Rgba8{255, 0, 0, 255},
                          Rgba8{0, 0, 7, 255}));
}

TEST(GltfSurface, ColoursMayBeBytesOfThreeChannels) {
  GlbFile file = square_glb();
  const size_t view = file.add_view(std::string(16, '\x40'), {{"byteStride", 4}});
  file.json["meshes"][0]["primitives"][0]["attributes"]["COLOR_0"] =
      file.add_accessor(view, "VEC3", 5121, 4, {{"normalized", true}});
  EXPECT_EQ(parsed(kGlb, file.glb()).colours[3], (Rgba8{137, 137, 137, 255}));
}

TEST(GltfSurface, QuantizedPositionsAreReadInAllTypes) {
  const auto file_of = [](int component, const std::string& bytes, bool is_normalized,
                          size_t stride) {
    GlbFile file;
    file.json["extensionsRequired"] = {"KHR_mesh_quantization"};
    const size_t view = file.add_view(bytes, {{"byteStride", stride}});
    file.add_primitive({{"POSITION", file.add_accessor(view, "VEC3", component, 3,
                                                       {{"normalized", is_normalized}})}});
    return file.glb();
  };
  const std::string signed_bytes("\0\0\0\0\x7f\0\0\0\0\x81\x80\0", 12);
  EXPECT_THAT(parsed(kGlb, file_of(5120, signed_bytes, true, 4)).vertices,
              ElementsAre(Vec3d(0, 0, 0), Vec3d(1, 0, 0), Vec3d(0, -1, -1)));
  EXPECT_EQ(parsed(kGlb, file_of(5121, signed_bytes, false, 4)).vertices[2], Vec3d(0, 129, 128));
  std::string shorts;
  for (const int v : {0, 0, 0, 0, 32767, 0, 0, 0, 0, -32768, 100, 0})
    shorts += bytes_of(static_cast<int16_t>(v));
  EXPECT_EQ(parsed(kGlb, file_of(5122, shorts, true, 8)).vertices[2].x(), 0);
  EXPECT_EQ(parsed(kGlb, file_of(5122, shorts, true, 8)).vertices[2].y(), -1);
  EXPECT_EQ(parsed(kGlb, file_of(5123, shorts, false, 8)).vertices[2].y(), 32768);
}

TEST(GltfSurface, SparseAccessorsReplaceElements) {
  GlbFile file = square_glb();
  const size_t indices = file.add_view(bytes_of(uint16_t{2}));
  const size_t values = file.add_view(bytes_of(5.F, 6.F, 7.F));
  file.json["accessors"][0]["sparse"] = {
      {"count", 1},
      {"indices", {{"bufferView", indices}, {"componentType", 5123}}},
      {"values", {{"bufferView", values}}}};
  const TriangleMesh mesh = parsed(kGlb, file.glb());
  EXPECT_EQ(mesh.vertices[2], Vec3d(5, 6, 7));
  EXPECT_EQ(mesh.vertices[3], Vec3d(0, 1, 0));
  file.json["accessors"][0].erase("bufferView");
  file.json["accessors"][0]["sparse"]["indices"]["bufferView"] =
      file.add_view(bytes_of(uint16_t{4}));
  EXPECT_THAT(refusal(kGlb, file.glb()), HasSubstr("sparse index 4"));
}

TEST(GltfSurface, FilesBesideATextAreAskedForByTheirPaths) {
  GlbFile file = square_glb();
  const std::string bin = file.bin;
  file.json["buffers"] = {{{"byteLength", bin.size()}, {"uri", "my%20scan.bin"}}};
  const std::string text = file.json.dump();
  EXPECT_THAT(refusal(kGlb, text), AllOf(HasSubstr("'my%20scan.bin'"), HasSubstr(".zip")));
  const auto beside = [&](const std::string& path) -> Result<std::span<const uint8_t>> {
    EXPECT_EQ(path, "my scan.bin");
    return std::span(reinterpret_cast<const uint8_t*>(bin.data()), bin.size());
  };
  const auto mesh =
      read_gltf({reinterpret_cast<const uint8_t*>(text.data()), text.size()}, "scan", beside);
  ASSERT_TRUE(mesh.is_ok()) << mesh.status().message();
  EXPECT_EQ(mesh->vertices, kSquareVertices);
  file.json["buffers"].push_back(file.json["buffers"][0]);
  const std::string twice = file.json.dump();
  EXPECT_THAT(
      read_gltf({reinterpret_cast<const uint8_t*>(twice.data()), twice.size()}, "scan", beside)
          .status()
          .message(),
      HasSubstr("buffer 1 is the same file"));
}

TEST(GltfSurface, SkinsMorphTargetsAndUnknownExtensionsAreRefusedByName) {
  EXPECT_THAT(refusal_with(square_glb(), "/nodes/0/skin", 0), HasSubstr("node 0 has a skin"));
  EXPECT_THAT(refusal_with(square_glb(), "/meshes/0/primitives/0/targets", TestJson::array()),
              HasSubstr("mesh 0, primitive 0 has morph targets"));
  EXPECT_THAT(refusal_with(square_glb(), "/extensionsRequired", {"ACME_splines"}),
              HasSubstr("\"ACME_splines\""));
  GlbFile known = square_glb();
  known.json["extensionsRequired"] = {"KHR_materials_unlit", "KHR_texture_transform"};
  EXPECT_EQ(parsed(kGlb, known.glb()).triangles.size(), 2u);
}

TEST(GltfSurface, ADamagedContainerIsNamed) {
  const std::string glb = square_glb().glb();
  for (size_t length = 0; length < glb.size(); ++length)
    EXPECT_FALSE(parse(kGlb, glb.substr(0, length)).is_ok()) << length << " bytes";
  EXPECT_THAT(refusal(kGlb, glb.substr(0, 100)),
              HasSubstr("promises " + std::to_string(glb.size()) + " bytes"));
  EXPECT_THAT(refusal(kGlb, "glTF" + bytes_of(uint32_t{1}, uint32_t{12})), HasSubstr("version 1"));
  EXPECT_THAT(refusal(kGlb, glb_of("{]", "")), HasSubstr("JSON is wrong at byte 2"));
  EXPECT_THAT(refusal(kGlb, glb_of("[]", "")), HasSubstr("not an object"));
  EXPECT_THAT(refusal(kGlb, glb_of("{}", "")), HasSubstr("version (none)"));
  EXPECT_THAT(refusal(kGlb, R"({"asset":{"version":"2.0"}})"), HasSubstr("no triangles"));
}

TEST(GltfSurface, DeepAndLongJsonIsRefused) {
  EXPECT_THAT(refusal(kGlb, std::string(100'000, '[')), HasSubstr("deeper than 64"));
  std::string many = "[";
  for (int i = 0; i < 1 << 20; ++i) many += "0,";
  EXPECT_THAT(refusal(kGlb, R"({"asset":{"version":"2.0"},"extras":)" + many + "0]}"),
              HasSubstr("more than 1048576 values"));
}

TEST(GltfSurface, AnObjectOfManyMembersIsRefused) {
  std::string members;
  for (int i = 0; i < 1024; ++i) members += ",\"" + std::to_string(i) + "\":0";
  EXPECT_THAT(refusal(kGlb, R"({"asset":{"version":"2.0"})" + members + "}"),
              HasSubstr("an object of more than 1024 members"));
}

TEST(GltfSurface, LoopsOfNodesAndFlatTransformsAreRefused) {
  GlbFile file = square_glb();
  file.json["nodes"][0]["children"] = {1};
  file.json["nodes"].push_back({{"children", {0}}});
  EXPECT_THAT(refusal(kGlb, file.glb()), HasSubstr("node 0 is reached twice"));
  EXPECT_THAT(refusal_with(square_glb(), "/nodes/0/scale", {1, 0, 1}), HasSubstr("flattens"));
  EXPECT_THAT(refusal_with(square_glb(), "/nodes/0/scale", {1, 1e300, 1e300}),
              HasSubstr("flattens"));
  EXPECT_THAT(refusal_with(square_glb(), "/nodes/0/rotation", {0, 0, 0, 0}),
              HasSubstr("quaternion of length 0"));
  EXPECT_THAT(refusal_with(square_glb(), "/nodes/0/translation", {0, 0}), HasSubstr("3 finite"));
  EXPECT_THAT(refusal_with(square_glb(), "/nodes/0/matrix", TestJson(16, 1.0)),
              HasSubstr("last row"));
  EXPECT_THAT(refusal_with(square_glb(), "/scenes/0/nodes", {7}), HasSubstr("element 7 of nodes"));
}

TEST(GltfSurface, CountsAndLengthsBeyondTheFileAreRefused) {
  const GlbFile square = square_glb();
  EXPECT_THAT(refusal_with(square, "/accessors/0/count", 5), HasSubstr("ends after 4"));
  EXPECT_THAT(refusal_with(square, "/accessors/0/count", 1e15), HasSubstr("ends after 4"));
  EXPECT_THAT(refusal_with(square, "/accessors/0/count", -1), HasSubstr("count is -1"));
  EXPECT_THAT(refusal_with(square, "/accessors/0/byteOffset", 4), HasSubstr("ends after 3"));
  EXPECT_THAT(refusal_with(square, "/accessors/0/componentType", 5124), HasSubstr("5124"));
  EXPECT_THAT(refusal_with(square, "/accessors/0/type", "MAT4"), HasSubstr("\"MAT4\""));
  EXPECT_THAT(refusal_with(square, "/accessors/0/type", "VEC2"), HasSubstr("2 components"));
  EXPECT_THAT(refusal_with(square, "/accessors/1/componentType", 5122), HasSubstr("indices"));
  EXPECT_THAT(refusal_with(square, "/bufferViews/0/byteLength", 1000), HasSubstr("byte 1000"));
  EXPECT_THAT(refusal_with(square, "/bufferViews/0/buffer", 3), HasSubstr("buffer 3"));
  EXPECT_THAT(refusal_with(square, "/bufferViews/0/byteStride", 4), HasSubstr("stride is 4"));
  EXPECT_THAT(refusal_with(square, "/meshes/0/primitives/0/indices", 9),
              HasSubstr("element 9 of accessors"));
  GlbFile far = square_glb();
  far.json["meshes"][0]["primitives"][0]["indices"] = far.add_indices({0, 1, 4});
  EXPECT_THAT(refusal(kGlb, far.glb()), HasSubstr("vertex 4, but there are 4"));
}

TEST(GltfSurface, HugeCountsWithoutBytesAreRefused) {
  GlbFile file = square_glb();
  file.json["accessors"][0].erase("bufferView");
  file.json["accessors"][0]["count"] = 1e9;
  EXPECT_THAT(refusal(kGlb, file.glb()), HasSubstr("the limit for a file of"));
  GlbFile instances = square_glb();
  TestJson& nodes = instances.json["nodes"];
  instances.json["meshes"][0]["primitives"] =
      TestJson(1000, instances.json["meshes"][0]["primitives"][0]);
  for (int i = 1; i < 2000; ++i) nodes.push_back({{"mesh", 0}});
  instances.json["scenes"] = TestJson::array();
  EXPECT_THAT(refusal(kGlb, instances.glb()), HasSubstr("the limit for a file of"));
}

TEST(GltfSurface, NanPositionsAreRefused) {
  GlbFile file;
  file.add_primitive({{"POSITION", file.add_floats("VEC3", 3, {0, 0, 0, 1, 0, NAN, 1, 1, 0})}});
  EXPECT_THAT(refusal(kGlb, file.glb()), HasSubstr("position 1 is not finite"));
}

}  // namespace
}  // namespace burnish
