#include <cmath>

#include <gmock/gmock.h>

#include "common/mesh/io/mesh_io.h"
#include "tests/common/gltf/glb_file.h"
#include "tests/common/mesh/texture_reference.h"
#include "tests/common/mesh/textured_square.h"
#include "tests/common/picture/encoding.h"
#include "tests/common/picture/webp_file.h"

namespace burnish {
namespace {

using testing::ElementsAre;

/// Coordinates of square_glb()'s corners; v points down.
const std::vector<float> kGltfCoordinates = {0.25F, 0.75F, 0.75F, 0.75F,
                                             0.75F, 0.25F, 0.25F, 0.25F};

Picture gltf_picture() {
  return drawn(13, 7, [](uint32_t x, uint32_t y) {
    return Rgba8{static_cast<uint8_t>(19 * x), static_cast<uint8_t>(83 * x * y + 31 * y),
                 static_cast<uint8_t>(36 * y), 255};
  });
}

/// The square with an embedded picture.
GlbFile textured_glb(const Picture& picture = square_picture()) {
  GlbFile file = square_glb();
  TestJson& primitive = file.json["meshes"][0]["primitives"][0];
  primitive["attributes"]["TEXCOORD_0"] = file.add_floats("VEC2", 4, kGltfCoordinates);
  primitive["material"] = 0;
  file.json["images"] = {
      {{"bufferView", file.add_view(png_of(picture))}, {"mimeType", "image/png"}}};
  file.json["textures"] = {{{"source", 0}}};
  file.json["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
  return file;
}

TestJson& look_of(GlbFile& file) {
  return file.json["materials"][0]["pbrMetallicRoughness"];
}

TestJson& attributes_of(GlbFile& file) {
  return file.json["meshes"][0]["primitives"][0]["attributes"];
}

std::vector<Rgba8> gltf_colours(const GlbFile& file) {
  return parsed(MeshFormat::kGlb, file.glb()).colours;
}

/// Returns the means of the square with its coordinates moved.
std::vector<Rgba8> gltf_reference(const Picture& picture, const Eigen::Affine2d& move,
                                  const TextureWraps& wraps) {
  const TriangleMesh mesh = parsed(MeshFormat::kGlb, square_glb().glb());
  std::vector<ReferenceCorners> corners(mesh.triangles.size());
  for (size_t t = 0; t < corners.size(); ++t)
    for (size_t k = 0; k < 3; ++k) {
      const size_t at = size_t{2} * mesh.triangles[t][k];
      corners[t][k] = move * Eigen::Vector2d(kGltfCoordinates[at], kGltfCoordinates[at + 1]);
    }
  return reference_colours(mesh, corners, picture, wraps);
}

TEST(GltfTextures, AnEmbeddedPictureGivesTheColoursOfAnObj) {
  EXPECT_EQ(gltf_colours(textured_glb()), square_colours());
}

TEST(GltfTextures, ThePictureMayBeThatOfAnOlderExtension) {
  GlbFile file = textured_glb();
  const TestJson look = {{"diffuseFactor", {1, 1, 1, 1}}, {"diffuseTexture", {{"index", 0}}}};
  file.json["materials"] = {{{"pbrMetallicRoughness", {{"baseColorFactor", {0.1, 0.2, 0.3, 1}}}},
                             {"extensions", {{"KHR_materials_pbrSpecularGlossiness", look}}}}};
  EXPECT_EQ(gltf_colours(file), square_colours());
}

TEST(GltfTextures, ThePictureMayBeWebpWithOrWithoutAnotherBesideIt) {
  GlbFile file = textured_glb(gltf_picture());
  file.json["extensionsRequired"] = file.json["extensionsUsed"] = {"EXT_texture_webp"};
  file.json["images"].push_back(
      {{"bufferView", file.add_view(webp_of(square_picture()))}, {"mimeType", "image/webp"}});
  file.json["textures"][0]["extensions"]["EXT_texture_webp"] = {{"source", 1}};
  EXPECT_EQ(gltf_colours(file), square_colours());
  file.json["textures"][0].erase("source");
  EXPECT_EQ(gltf_colours(file), square_colours());
}

TEST(GltfTextures, ThePictureMayBeTheLightThatABlackSurfaceGives) {
  GlbFile file = textured_glb();
  TestJson light = {{"emissiveTexture", {{"index", 0}}}, {"emissiveFactor", {1, 1, 1}}};
  file.json["materials"] = {light};
  EXPECT_EQ(gltf_colours(file), square_colours());
  light["pbrMetallicRoughness"] = {{"baseColorFactor", {0, 0, 0, 1}}};
  file.json["materials"] = {light};
  EXPECT_EQ(gltf_colours(file), square_colours());
  light["pbrMetallicRoughness"] = {{"baseColorFactor", {1, 0, 0, 1}}};  // red, with lamps
  file.json["materials"] = {light};
  EXPECT_NE(gltf_colours(file), square_colours());
  light.erase("emissiveFactor");
  light["pbrMetallicRoughness"] = {{"baseColorFactor", {0, 0, 0, 1}}};
  file.json["materials"] = {light};
  EXPECT_NE(gltf_colours(file), square_colours()) << "the factor of none is 0";
}

TEST(GltfTextures, ThePictureMayBeADataUriOrAFileBeside) {
  const std::string png = png_of(square_picture());
  const std::span bytes(reinterpret_cast<const uint8_t*>(png.data()), png.size());
  GlbFile file = textured_glb();
  file.json["images"][0] = {{"uri", "data:image/png;base64," + to_base64(bytes)}};
  EXPECT_EQ(gltf_colours(file), square_colours());
  file.json["images"][0] = {{"uri", "my%20skin.png"}};
  EXPECT_TRUE(gltf_colours(file).empty());  // nothing lies beside it
  FilesInMemory beside;
  beside.files = {{"maps/my skin.png", png}};
  const std::string glb = file.glb();
  const auto mesh = read_mesh({reinterpret_cast<const uint8_t*>(glb.data()), glb.size()},
                              MeshFormat::kGlb, "scan", {&beside, "maps/scan.glb"});
  EXPECT_EQ(mesh.value().colours, square_colours());
}

TEST(GltfTextures, SamplersWrapEachCoordinate) {
  const Picture picture = gltf_picture();
  const std::pair<int, TextureWrap> wraps[] = {
      {10497, TextureWrap::kRepeat}, {33648, TextureWrap::kMirror}, {33071, TextureWrap::kClamp}};
  const Eigen::Affine2d move = Eigen::Translation2d(0.7, -0.4) * Eigen::Scaling(2.5, 1.5);
  for (const auto& [s, u] : wraps)
    for (const auto& [t, v] : wraps) {
      GlbFile file = textured_glb(picture);
      file.json["samplers"] = {{{"wrapS", s}, {"wrapT", t}}};
      file.json["textures"][0]["sampler"] = 0;
      look_of(file)["baseColorTexture"]["extensions"]["KHR_texture_transform"] = {
          {"offset", {0.7, -0.4}}, {"scale", {2.5, 1.5}}};
      EXPECT_LE(largest_difference(gltf_colours(file), gltf_reference(picture, move, {u, v})), 1)
          << s << " " << t;
    }
}

TEST(GltfTextures, ATransformTurnsCounterClockwiseWhereVPointsDown) {
  const Picture picture = gltf_picture();
  GlbFile file = textured_glb(picture);
  look_of(file)["baseColorTexture"]["extensions"]["KHR_texture_transform"] = {
      {"offset", {0.1, 0.2}}, {"rotation", 0.6}, {"scale", {0.5, 2}}};
  Eigen::Affine2d move = Eigen::Affine2d::Identity();
  const double c = std::cos(0.6), s = std::sin(0.6);
  move.linear() << c * 0.5, s * 2, -s * 0.5, c * 2;
  move.translation() << 0.1, 0.2;
  EXPECT_LE(largest_difference(gltf_colours(file), gltf_reference(picture, move, {})), 1);
}

TEST(GltfTextures, ATransformMayNameOtherCoordinates) {
  GlbFile file = textured_glb();
  attributes_of(file)["TEXCOORD_1"] = attributes_of(file)["TEXCOORD_0"];
  attributes_of(file)["TEXCOORD_0"] = file.add_floats("VEC2", 4, std::vector<float>(8, 0.5F));
  TestJson& texture = look_of(file)["baseColorTexture"];
  texture["texCoord"] = 1;
  EXPECT_EQ(gltf_colours(file), square_colours());
  texture["texCoord"] = 0;
  texture["extensions"]["KHR_texture_transform"]["texCoord"] = 1;
  EXPECT_EQ(gltf_colours(file), square_colours());
}

TEST(GltfTextures, NormalizedShortsAreCoordinates) {
  GlbFile file = textured_glb();
  std::string bytes;
  for (const float x : kGltfCoordinates)
    bytes += bytes_of(static_cast<uint16_t>(std::lround(65535 * x)));
  attributes_of(file)["TEXCOORD_0"] =
      file.add_accessor(file.add_view(bytes), "VEC2", 5123, 4, {{"normalized", true}});
  EXPECT_LE(largest_difference(gltf_colours(file), square_colours()), 1);
}

TEST(GltfTextures, TheFactorAndTheVerticesColoursAreMultiplied) {
  GlbFile file = textured_glb(drawn(2, 2, [](uint32_t, uint32_t) {
    return Rgba8{188, 255, 255, 255};
  }));
  look_of(file)["baseColorFactor"] = {0.5, 0.5, 1, 1};
  attributes_of(file)["COLOR_0"] =
      file.add_floats("VEC4", 4, {1, 1, 1, 1, 0.5F, 1, 0, 1, 1, 1, 1, 0.5F, 1, 1, 1, 1});
  const std::vector<Rgba8> expected = {
      {137, 188, 255, 255}, {99, 188, 0, 255}, {137, 188, 255, 128}, {137, 188, 255, 255}};
  EXPECT_LE(largest_difference(gltf_colours(file), expected), 1);
}

TEST(GltfTextures, MaterialsWithoutPicturesGiveTheirFactor) {
  GlbFile file = square_glb();
  TestJson& primitives = file.json["meshes"][0]["primitives"];
  primitives[0]["indices"] = file.add_indices({0, 1, 2});
  primitives.push_back(primitives[0]);
  primitives[1]["indices"] = file.add_indices({0, 2, 3});
  primitives[0]["material"] = 0;
  file.json["materials"] = {{{"pbrMetallicRoughness", {{"baseColorFactor", {1, 0, 0, 1}}}}}};
  const Rgba8 between = {255, 188, 188, 255};
  EXPECT_THAT(gltf_colours(file),
              ElementsAre(between, Rgba8{255, 0, 0, 255}, between, Rgba8{255, 255, 255, 255}));
}

TEST(GltfTextures, AMirroringNodeKeepsItsCoordinates) {
  GlbFile file = textured_glb();
  file.json["nodes"][0]["scale"] = {-1, 1, 1};
  EXPECT_EQ(gltf_colours(file), square_colours());
}

TEST(GltfTextures, WhateverIsWrongWithATextureTheScanIsRead) {
  const std::pair<const char*, TestJson> wrongs[] = {
      {"/materials/0", 3},
      {"/materials/0/pbrMetallicRoughness", "red"},
      {"/materials/0/pbrMetallicRoughness/baseColorFactor", {1, 1, "x", 1}},
      {"/materials/0/pbrMetallicRoughness/baseColorTexture", TestJson::array()},
      {"/materials/0/pbrMetallicRoughness/baseColorTexture/index", -1},
      {"/materials/0/pbrMetallicRoughness/baseColorTexture/index", 9},
      {"/materials/0/pbrMetallicRoughness/baseColorTexture/texCoord", 5},
      {"/materials/0/pbrMetallicRoughness/baseColorTexture/texCoord", "0"},
      {"/materials/0/pbrMetallicRoughness/baseColorTexture/extensions",
       {{"KHR_texture_transform", {{"scale", 2}, {"offset", {1}}, {"rotation", "left"}}}}},
      {"/materials/0/pbrMetallicRoughness/baseColorTexture/extensions",
       {{"KHR_texture_transform", {{"scale", {1e300, 1e300}}}}}},
      {"/meshes/0/primitives/0/material", 1},
      {"/meshes/0/primitives/0/material", "skin"},
      {"/meshes/0/primitives/0/attributes/TEXCOORD_0", 77},
      {"/meshes/0/primitives/0/attributes/TEXCOORD_0", 0},
      {"/meshes/0/primitives/0/attributes/TEXCOORD_0", "x"},
      {"/accessors/2/count", 3},
      {"/accessors/2/bufferView", 99},
      {"/accessors/2/type", "MAT2"},
      {"/textures", 1},
      {"/textures/0/source", 4},
      {"/textures/0/sampler", 4},
      {"/images/0", "skin"},
      {"/images/0/bufferView", 44},
      {"/images/0/uri", "data:image/png;base64,????"},
      {"/images/0/uri", "data:image/png,raw"},
      {"/images/0/uri", "../gone.png"},
      {"/bufferViews/3/byteLength", 20},
  };
  const TriangleMesh square = parsed(MeshFormat::kGlb, square_glb().glb());
  for (const auto& [pointer, value] : wrongs) {
    GlbFile file = textured_glb();
    file.json[TestJson::json_pointer(pointer)] = value;
    const TriangleMesh mesh = parsed(MeshFormat::kGlb, file.glb());
    EXPECT_EQ(mesh.vertices, square.vertices) << pointer;
    EXPECT_EQ(mesh.triangles, square.triangles) << pointer;
  }
}

}  // namespace
}  // namespace burnish
