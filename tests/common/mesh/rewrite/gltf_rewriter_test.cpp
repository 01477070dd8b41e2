#include "common/mesh/rewrite/gltf/gltf_rewriter.h"

#include "common/generate/generate.h"
#include "common/mesh/gltf/gltf_surface.h"
#include "tests/common/gltf/glb_file.h"
#include "tests/common/gltf/packed_glb.h"
#include "tests/common/mesh/rewrite/rewriting.h"

namespace burnish {
namespace {

using testing::HasSubstr;

constexpr MeshFormat kRewrittenGlb = MeshFormat::kGlb;

std::string rewritten_glb(const std::string& content, const Move& move = stay) {
  return rewritten(kRewrittenGlb, content, move);
}

Vec3d twice(size_t, const Vec3d& position) {
  return 2 * position + Vec3d(1, 2, 3);
}

/// A GLB file's JSON and its BIN chunk.
struct Chunks {
  TestJson json;
  std::string bin;
};

Chunks chunks_of(const std::string& glb) {
  uint32_t json_bytes = 0;
  std::memcpy(&json_bytes, glb.data() + 12, sizeof json_bytes);
  return {TestJson::parse(glb.substr(20, json_bytes)), glb.substr(20 + json_bytes + 8)};
}

/// Checks that a moved file reads back moved, triangle by triangle.
void expect_moved(const std::string& content, const Move& move, double tolerance = 1e-6) {
  const TriangleMesh before = parsed(kRewrittenGlb, content);
  const TriangleMesh after = parsed(kRewrittenGlb, rewritten_glb(content, move));
  ASSERT_EQ(after.triangles.size(), before.triangles.size());
  for (size_t t = 0; t < before.triangles.size(); ++t) {
    for (size_t c = 0; c < 3; ++c) {
      const uint32_t v = before.triangles[t][c];
      const Vec3d wanted = move(v, before.vertices[v]);
      ASSERT_LT((after.vertices[after.triangles[t][c]] - wanted).norm(),
                tolerance * (1 + wanted.norm()))
          << t;
    }
  }
  EXPECT_EQ(after.colours.size(), before.colours.empty() ? 0 : after.vertices.size());
}

TEST(GltfRewriter, TheCapHoldsInFloats) {
  const std::string content = square_glb().glb();
  constexpr double kCap = 1e-6;
  const auto move = [](size_t v, const Vec3d& p) -> Vec3d {
    const auto angle = static_cast<double>(v + 1);
    return p + (1 - 1e-6) * kCap * Vec3d(std::cos(angle), 0, std::sin(angle));
  };
  EXPECT_LE(largest_move(kRewrittenGlb, content, rewritten(kRewrittenGlb, content, move, kCap)),
            kCap);
  EXPECT_GT(largest_move(kRewrittenGlb, content, rewritten(kRewrittenGlb, content, move)), kCap);
}

/// A square with normals, texture coordinates, a picture, extras, and members nobody knows.
GlbFile rich_square() {
  GlbFile file = square_glb();
  std::string bytes;
  for (int i = 0; i < 4; ++i) bytes += bytes_of(0.F, 0.F, 1.F, 0.25F * float(i), 0.5F);
  const size_t view = file.add_view(bytes, {{"byteStride", 20}});
  TestJson& primitive = file.json["meshes"][0]["primitives"][0];
  primitive["attributes"]["NORMAL"] = file.add_accessor(view, "VEC3", 5126, 4);
  primitive["attributes"]["TEXCOORD_0"] =
      file.add_accessor(view, "VEC2", 5126, 4, {{"byteOffset", 12}});
  primitive["attributes"]["COLOR_0"] =
      file.add_accessor(file.add_view("0123456789abcdef"), "VEC4", 5121, 4, {{"normalized", true}});
  primitive["material"] = 0;
  file.json["images"] = {{{"bufferView", file.add_view("a picture")}, {"mimeType", "image/png"}}};
  file.json["materials"] = {
      {{"name", "skin"}, {"pbrMetallicRoughness", {{"roughnessFactor", 0.1}}}}};
  file.json["nodes"][0]["extras"] = {{"scanner", 7.0}, {"big", 12345678901234567}};
  file.json["extensions"] = {{"ACME_unknown", {{"a", {1, 2.5, nullptr}}}}};
  return file;
}

TEST(GltfRewriter, AMeshThatStaysGivesTheSameBytes) {
  const TriangleMesh sphere = make_icosphere(2, 1);
  for (const std::string& content :
       {rich_square().glb(), rich_square().gltf(), rich_square().gltf(3),
        draco_glb(sphere, draco::MESH_EDGEBREAKER_ENCODING).glb(), meshopt_glb(sphere).glb(),
        meshopt_glb(sphere, true).glb()})
    EXPECT_EQ(rewritten_glb(content), content);
}

TEST(GltfRewriter, OnlyPositionsAndTheirBoundsChange) {
  const std::string content = rich_square().glb();
  const Chunks before = chunks_of(content), after = chunks_of(rewritten_glb(content, twice));
  TestJson expected = before.json;
  expected["accessors"][0]["min"] = {1, 2, 3};
  expected["accessors"][0]["max"] = {3, 4, 3};
  EXPECT_EQ(after.json, expected);
  EXPECT_EQ(after.json.dump().size(), expected.dump().size() + 12);  // 1.0 for 1
  ASSERT_EQ(after.bin.size(), before.bin.size());
  EXPECT_EQ(after.bin.substr(0, 12), bytes_of(1.F, 2.F, 3.F));
  EXPECT_EQ(after.bin.substr(48), before.bin.substr(48));
}

TEST(GltfRewriter, OtherChunksAndBytesBehindTheFileStay) {
  const std::string glb = square_glb().glb();
  const std::string chunk = bytes_of(uint32_t{4}) + "ACMEabcd";
  const std::string longer = bytes_of(static_cast<uint32_t>(glb.size() + chunk.size()));
  const std::string content = std::string(glb).replace(8, 4, longer) + chunk + "noise";
  const std::string after = rewritten_glb(content, twice);
  EXPECT_THAT(after, testing::EndsWith(chunk + "noise"));
  EXPECT_EQ(after.substr(8, 4), bytes_of(static_cast<uint32_t>(after.size() - 5)));
  expect_moved(content, twice);
}

TEST(GltfRewriter, StripsPointsAndLinesKeepTheirCorners) {
  GlbFile file = square_glb();
  TestJson& primitive = file.json["meshes"][0]["primitives"][0];
  primitive["indices"] = file.add_indices({0, 1, 3, 2});
  primitive["mode"] = 5;
  const size_t points = file.add_floats("VEC3", 1, {9, 9, 9});
  file.add_primitive({{"POSITION", points}})["mode"] = 0;
  const Chunks after = chunks_of(rewritten_glb(file.glb(), twice));
  EXPECT_EQ(after.json["meshes"], file.json["meshes"]);
  EXPECT_EQ(after.bin.substr(48), file.bin.substr(48));
}

TEST(GltfRewriter, AVertexThatStaysKeepsItsBytes) {
  const std::string content = rich_square().glb();
  const Move lift = [](size_t v, const Vec3d& p) -> Vec3d {
    return v == 2 ? p + Vec3d(0, 0, 1) : p;
  };
  const std::string bin = chunks_of(rewritten_glb(content, lift)).bin;
  EXPECT_EQ(bin.substr(0, 32), chunks_of(content).bin.substr(0, 32));
  EXPECT_EQ(bin.substr(32, 4), bytes_of(1.F));
}

TEST(GltfRewriter, NormalsFollowTheSurfaceAndTextureCoordinatesStay) {
  const std::string content = rich_square().glb();
  const Move tip = [](size_t, const Vec3d& p) { return Vec3d(p.x(), p.y(), p.x()); };
  const std::string before = chunks_of(content).bin,
                    bin = chunks_of(rewritten_glb(content, tip)).bin;
  for (size_t v = 0; v < 4; ++v) {
    const size_t at = 60 + 20 * v;
    Vec3f normal;
    std::memcpy(normal.data(), bin.data() + at, sizeof normal);
    EXPECT_LT((normal - Vec3f(-1, 0, 1).normalized()).norm(), 1e-6) << v;
    EXPECT_EQ(bin.substr(at + 12, 8), before.substr(at + 12, 8)) << v;
  }
}

TEST(GltfRewriter, NormalsKeepCreasesAndHaveNoSeams) {
  GlbFile file;
  // Two squares that meet at an edge. The first is torn along its diagonal, as at a seam of texture
  // coordinates.
  const std::vector<float> positions = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 0, 0, 1, 1, 0,
                                        0, 1, 0, 1, 0, 0, 1, 0, 1, 1, 1, 1, 1, 1, 0};
  std::vector<float> normals;
  for (int v = 0; v < 6; ++v) normals.insert(normals.end(), {0, 0, 1});
  for (int v = 6; v < 10; ++v) normals.insert(normals.end(), {-1, 0, 0});
  const TestJson attributes = {{"POSITION", file.add_floats("VEC3", 10, positions)},
                               {"NORMAL", file.add_floats("VEC3", 10, normals)}};
  file.add_primitive(attributes)["indices"] =
      file.add_indices({0, 1, 2, 3, 4, 5, 6, 7, 8, 6, 8, 9});
  const Move bend = [](size_t, const Vec3d& p) -> Vec3d { return p + Vec3d(0, 0, p.x() * p.y()); };
  const std::string bin = chunks_of(rewritten_glb(file.glb(), bend)).bin;
  const auto normal = [&](size_t v) {
    Vec3f value;
    std::memcpy(value.data(), bin.data() + 120 + 12 * v, sizeof value);
    return value;
  };
  EXPECT_EQ(normal(0), normal(3));
  EXPECT_EQ(normal(2), normal(4));
  EXPECT_LT(normal(2).z(), 0.95F);
  EXPECT_EQ(normal(6), Vec3f(-1, 0, 0));
}

TEST(GltfRewriter, PositionsAreWrittenInTheFrameOfTheirNode) {
  GlbFile file = rich_square();
  file.json["nodes"] = {{{"children", {1}}, {"translation", {100, 0, 0}}, {"scale", {2, 2, 2}}},
                        {{"mesh", 0}, {"rotation", {0, 0, 1, 0}}}};
  const Move shift = [](size_t, const Vec3d& p) -> Vec3d { return p + Vec3d(4, 0, 0); };
  expect_moved(file.glb(), shift);
  const Chunks after = chunks_of(rewritten_glb(file.glb(), shift));
  EXPECT_EQ(after.json["nodes"], file.json["nodes"]);
  EXPECT_EQ(after.bin.substr(0, 4), bytes_of(-2.F));
}

TEST(GltfRewriter, NodesThatMoveOneMeshDifferentlyGetCopies) {
  GlbFile file = rich_square();
  file.json["nodes"].push_back({{"mesh", 0}, {"translation", {5, 0, 0}}});
  file.json["nodes"].push_back({{"mesh", 0}, {"translation", {10, 0, 0}}});
  file.json["scenes"][0]["nodes"] = {0, 1, 2};
  const Move lift = [](size_t, const Vec3d& p) -> Vec3d {
    return p.x() > 9 ? p + Vec3d(0, 0, p.y()) : p;
  };
  expect_moved(file.glb(), lift);
  const TestJson json = chunks_of(rewritten_glb(file.glb(), lift)).json;
  EXPECT_EQ(json["meshes"].size(), 2u);
  EXPECT_EQ(json["meshes"][0], file.json["meshes"][0]);
  EXPECT_EQ(json["meshes"][1]["primitives"][0]["material"], 0);
  EXPECT_EQ(json["nodes"][1]["mesh"], 0);
  EXPECT_EQ(json["nodes"][2]["mesh"], 1);
  const Move same = [](size_t, const Vec3d& p) -> Vec3d { return p + Vec3d(0, 0, 1); };
  EXPECT_EQ(chunks_of(rewritten_glb(file.glb(), same)).json["meshes"].size(), 1u);
}

TEST(GltfRewriter, BytesThatBelongToOthersTooStay) {
  GlbFile file = square_glb();
  file.json["meshes"][0]["primitives"][0]["attributes"]["_SOURCE"] =
      file.add_accessor(0, "VEC3", 5126, 4);
  const std::string content = file.glb();
  expect_moved(content, twice);
  const Chunks after = chunks_of(rewritten_glb(content, twice));
  EXPECT_EQ(after.json["accessors"][2], file.json["accessors"][2]);
  EXPECT_EQ(after.bin.substr(0, 48), file.bin.substr(0, 48));
  EXPECT_EQ(after.json["buffers"][0]["byteLength"], file.bin.size() + 48);
}

TEST(GltfRewriter, QuantizedAndSparsePositionsBecomeFloatsOfTheirOwn) {
  GlbFile file;
  file.json["extensionsUsed"] = file.json["extensionsRequired"] = {"KHR_mesh_quantization"};
  file.json["nodes"][0]["scale"] = {10, 10, 10};
  const std::string bytes("\0\0\0\0\x7f\0\0\0\0\x7f\0\0", 12);
  const size_t view = file.add_view(bytes, {{"byteStride", 4}});
  const size_t quantized =
      file.add_accessor(view, "VEC3", 5120, 3, {{"normalized", true}, {"name", "p"}});
  file.add_primitive({{"POSITION", quantized}});
  expect_moved(file.glb(), twice);
  const TestJson accessor = chunks_of(rewritten_glb(file.glb(), twice)).json["accessors"][0];
  EXPECT_EQ(accessor["componentType"], 5126);
  EXPECT_EQ(accessor["name"], "p");
  EXPECT_FALSE(accessor.contains("normalized"));

  GlbFile sparse = square_glb();
  sparse.json["accessors"][0]["sparse"] = {
      {"count", 1},
      {"indices", {{"bufferView", sparse.add_view(std::string(1, '\2'))}, {"componentType", 5121}}},
      {"values", {{"bufferView", sparse.add_view(bytes_of(3.F, 3.F, 3.F))}}}};
  expect_moved(sparse.glb(), twice);
}

TEST(GltfRewriter, MeshoptPositionsBecomeFloatsAndIndicesStayPacked) {
  const GlbFile file = meshopt_glb(make_icosphere(3, 1));
  expect_moved(file.glb(), twice);
  const Chunks after = chunks_of(rewritten_glb(file.glb(), twice));
  EXPECT_EQ(after.json["extensionsRequired"], file.json["extensionsRequired"]);
  EXPECT_EQ(after.json["accessors"][1], file.json["accessors"][1]);
  EXPECT_EQ(after.bin.substr(0, file.bin.size()), file.bin);
}

TEST(GltfRewriter, DracoIsUnpackedWhereItMovesAndThenGone) {
  GlbFile file = draco_glb(make_icosphere(3, 1), draco::MESH_EDGEBREAKER_ENCODING);
  file.json["extensionsUsed"].push_back("KHR_materials_unlit");
  expect_moved(file.glb(), twice);
  const TestJson json = chunks_of(rewritten_glb(file.glb(), twice)).json;
  EXPECT_EQ(json["extensionsUsed"], TestJson({"KHR_materials_unlit"}));
  EXPECT_FALSE(json.contains("extensionsRequired"));
  EXPECT_FALSE(json["meshes"][0]["primitives"][0].contains("extensions"));
  GlbFile two = file;
  two.json["nodes"].push_back({{"mesh", 0}, {"translation", {9, 0, 0}}});
  two.json["scenes"][0]["nodes"] = {0, 1};
  const Move one = [](size_t, const Vec3d& p) -> Vec3d {
    return p.x() > 5 ? p + Vec3d(1, 0, 0) : p;
  };
  expect_moved(two.glb(), one);
  const TestJson split = chunks_of(rewritten_glb(two.glb(), one)).json;
  EXPECT_EQ(split["meshes"][0], file.json["meshes"][0]);
  EXPECT_EQ(split["extensionsRequired"], file.json["extensionsRequired"]);
}

TEST(GltfRewriter, WhatDracoHeldBesidePositionsKeepsItsValues) {
  const GlbFile file = draco_glb(make_icosphere(3, 1), draco::MESH_SEQUENTIAL_ENCODING);
  const Chunks after = chunks_of(rewritten_glb(file.glb(), twice));
  const auto floats_at = [&](size_t accessor) {
    const size_t view = after.json["accessors"][accessor]["bufferView"];
    return after.bin.data() + after.json["bufferViews"][view]["byteOffset"].get<size_t>();
  };
  for (size_t i = 0; i < after.json["accessors"][0]["count"]; ++i) {
    Vec3f position;
    Eigen::Vector2f texture;
    std::memcpy(position.data(), floats_at(0) + i * sizeof position, sizeof position);
    std::memcpy(texture.data(), floats_at(2) + i * sizeof texture, sizeof texture);
    const Vec3f before = (position - Vec3f(1, 2, 3)) / 2;
    ASSERT_LT((texture - texture_at(before)).norm(), 1e-3F) << i;
  }
}

TEST(GltfRewriter, ATextKeepsItsIndentAndItsDataUri) {
  for (const int indent : {-1, 2, 3}) {
    const std::string content = rich_square().gltf(indent) + "\n";
    const std::string after = rewritten_glb(content, twice);
    EXPECT_EQ(std::count(after.begin(), after.end(), '\n'),
              std::count(content.begin(), content.end(), '\n'));
    EXPECT_THAT(after, HasSubstr("data:application/octet-stream;base64,"));
    expect_moved(content, twice);
  }
}

TEST(GltfRewriter, FilesBesideATextAreReturnedWhereTheyChanged) {
  GlbFile file = rich_square();
  const std::string bin = file.bin, other = "untouched";
  file.json["buffers"] = {{{"byteLength", bin.size()}, {"uri", "a.bin"}},
                          {{"byteLength", other.size()}, {"uri", "b.bin"}}};
  const std::string text = file.json.dump();
  const auto span_of = [](const std::string& s) {
    return std::span(reinterpret_cast<const uint8_t*>(s.data()), s.size());
  };
  const GltfFilesBeside beside = [&](const std::string& path) -> Result<std::span<const uint8_t>> {
    return span_of(path == "a.bin" ? bin : other);
  };
  TriangleMesh after = read_gltf(span_of(text), "scan", beside).value();
  const std::vector<Vec3d> before = after.vertices;
  for (Vec3d& vertex : after.vertices) vertex *= 2;
  std::string written;
  OutputBuffer output([&](std::string_view piece) {
    written += piece;
    return Status::ok();
  });
  std::vector<GltfFileBeside> changed;
  ASSERT_TRUE(
      rewrite_gltf(span_of(text), "scan", beside, {before, after}, {}, output, changed).is_ok());
  ASSERT_TRUE(output.flush().is_ok());
  ASSERT_EQ(changed.size(), 1u);
  EXPECT_EQ(changed[0].path, "a.bin");
  EXPECT_EQ(changed[0].bytes.size(), bin.size());
  EXPECT_EQ(TestJson::parse(written)["accessors"][0]["max"], TestJson({2, 2, 0}));
}

TEST(GltfRewriter, AnotherFileIsDataLoss) {
  const std::string content = square_glb().glb();
  TriangleMesh after = parsed(kRewrittenGlb, content);
  std::vector<Vec3d> before = after.vertices;
  before[1].x() = 7;
  OutputBuffer output([](std::string_view) { return Status::ok(); });
  std::vector<GltfFileBeside> none;
  const auto bytes = std::span(reinterpret_cast<const uint8_t*>(content.data()), content.size());
  EXPECT_EQ(rewrite_gltf(bytes, "scan", nullptr, {before, after}, {}, output, none).code(),
            StatusCode::kDataLoss);
  EXPECT_EQ(
      rewrite_gltf(bytes.first(90), "scan", nullptr, {before, after}, {}, output, none).code(),
      StatusCode::kDataLoss);
}

}  // namespace
}  // namespace burnish
