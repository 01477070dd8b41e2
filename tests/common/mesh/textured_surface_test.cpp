#include "common/mesh/io/textured_surface.h"

#include <optional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/archive/archive_writer.h"
#include "tests/common/mesh/textured_square.h"
#include "tests/common/picture/encoding.h"

namespace burnish {
namespace {

using testing::HasSubstr;

std::vector<uint8_t> packed(const std::map<std::string, std::string>& files) {
  std::vector<std::vector<uint8_t>> contents;
  for (const auto& [name, text] : files) contents.emplace_back(text.begin(), text.end());
  std::vector<FileToPack> to_pack;
  for (const auto& [name, text] : files) to_pack.push_back({name, contents[to_pack.size()]});
  return pack_archive(to_pack).value();
}

const std::map<std::string, std::string> kSquare = {
    {"square.obj", kSquareObj}, {"square.mtl", kSquareMtl}, {"skin.png", png_of(square_picture())}};

/// The surface that a reader handed over.
struct Taken {
  Status status;
  std::optional<TexturedSurface> surface;
  std::vector<uint8_t> picture;  ///< the first one's file
};

Taken read_surface(const std::vector<uint8_t>& bytes, MeshFormat format) {
  Taken taken;
  taken.status = read_textured_surface(bytes, format, "square", [&](const TexturedSurface& read) {
    if (!read.textures.pictures.empty()) taken.picture = read.textures.pictures[0].read().value();
    taken.surface = read;
    return Status::ok();
  });
  return taken;
}

TEST(TexturedSurface, OfAnArchiveHasTheMeshAndItsPictures) {
  const Taken taken = read_surface(packed(kSquare), MeshFormat::kZip);
  ASSERT_TRUE(taken.status.is_ok()) << taken.status.to_string();
  EXPECT_EQ(taken.surface->mesh.triangles.size(), 2u);
  EXPECT_EQ(taken.surface->textures.triangles.size(), 2u);
  const std::string& png = kSquare.at("skin.png");
  EXPECT_EQ(taken.picture, std::vector<uint8_t>(png.begin(), png.end()));
}

TEST(TexturedSurface, ShowsTexturesInPlaceOfAnObjsOwnColours) {
  auto files = kSquare;
  std::string& obj = files["square.obj"];
  obj.replace(obj.find("v 0 0 0"), 7, "v 0 0 0 1 0 0");
  const Taken taken = read_surface(packed(files), MeshFormat::kZip);
  ASSERT_TRUE(taken.status.is_ok()) << taken.status.to_string();
  EXPECT_FALSE(taken.surface->mesh.has_colours());
  EXPECT_FALSE(taken.surface->textures.triangles.empty());
}

TEST(TexturedSurface, WithoutMaterialsHasNoTextures) {
  const Taken taken = read_surface(packed({{"square.obj", kSquareObj}}), MeshFormat::kZip);
  ASSERT_TRUE(taken.status.is_ok()) << taken.status.to_string();
  EXPECT_TRUE(taken.surface->textures.triangles.empty());
}

TEST(TexturedSurface, WithoutTexturesKeepsAnObjsOwnColours) {
  const std::string obj = "v 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv 0 1 0 1 0 0\nf 1 2 3\n";
  const Taken taken = read_surface(packed({{"square.obj", obj}}), MeshFormat::kZip);
  ASSERT_TRUE(taken.status.is_ok()) << taken.status.to_string();
  EXPECT_TRUE(taken.surface->mesh.has_colours());
}

TEST(TexturedSurface, OfAFormatWithoutTexturesIsRefused) {
  const Taken taken = read_surface({}, MeshFormat::kStl);
  EXPECT_EQ(taken.status.code(), StatusCode::kInvalidArgument);
  EXPECT_THAT(taken.status.message(), HasSubstr("square"));
}

TEST(TexturedSurface, FailsAsWhatTakesItDoes) {
  const Status status =
      read_textured_surface(packed(kSquare), MeshFormat::kZip, "square",
                            [](const TexturedSurface&) { return resource_exhausted("full"); });
  EXPECT_EQ(status.code(), StatusCode::kResourceExhausted);
}

TEST(MayHavePictures, TellsFromTheDirectoryAlone) {
  EXPECT_TRUE(may_have_pictures(packed(kSquare), MeshFormat::kZip));
  EXPECT_FALSE(may_have_pictures(packed({{"square.obj", kSquareObj}, {"square.mtl", kSquareMtl}}),
                                 MeshFormat::kZip));
  const std::string plain = R"({"asset": {"version": "2.0"}})";
  const std::string textured = R"({"asset": {"version": "2.0"}, "images": [{"uri": "a.png"}]})";
  EXPECT_FALSE(may_have_pictures({reinterpret_cast<const uint8_t*>(plain.data()), plain.size()},
                                 MeshFormat::kGltf));
  EXPECT_TRUE(may_have_pictures(
      {reinterpret_cast<const uint8_t*>(textured.data()), textured.size()}, MeshFormat::kGltf));
  EXPECT_FALSE(may_have_pictures({}, MeshFormat::kPly));
}

TEST(MayHavePictures, ADamagedFileMay) {
  EXPECT_TRUE(may_have_pictures(std::vector<uint8_t>(100), MeshFormat::kZip));
  EXPECT_TRUE(may_have_pictures(std::vector<uint8_t>(100), MeshFormat::kGlb));
}

}  // namespace
}  // namespace burnish
