#include "common/mesh/obj/mtl_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/base/limits.h"

namespace burnish {
namespace {

using testing::ElementsAre;

Result<MaterialFile> read(const std::string& text) {
  return read_material_file({reinterpret_cast<const uint8_t*>(text.data()), text.size()}, "a.mtl");
}

MaterialFile materials_of(const std::string& text) {
  auto file = read(text);
  EXPECT_TRUE(file.is_ok()) << file.status().message();
  return file.is_ok() ? std::move(file).value() : MaterialFile();
}

TEST(MtlReader, EachMaterialHasItsColourAndItsPicture) {
  const MaterialFile file = materials_of(
      "# Blender MTL File\r\nnewmtl Old Stone\r\nKd 1 0.5 0\r\nmap_Kd stone.png\r\n"
      "newmtl plain\nKa 1 1 1\n");
  ASSERT_EQ(file.materials.size(), 2u);
  EXPECT_EQ(file.materials[0].name, "Old Stone");
  EXPECT_EQ(file.materials[0].diffuse, (Rgba8{255, 128, 0, 255}));
  EXPECT_EQ(file.materials[0].picture, "stone.png");
  EXPECT_EQ(file.materials[1].diffuse, std::nullopt);
  EXPECT_EQ(file.materials[1].picture, "");
}

TEST(MtlReader, OptionsComeBeforeANameWithBlanks) {
  const MaterialFile file = materials_of(
      "newmtl a\nmap_Kd -blendu on -s 2 3 1 -o 0.5 -mm 0 1 -clamp on -texres 256 my skin 2.png \n");
  const Material& a = file.materials[0];
  EXPECT_EQ(a.picture, "my skin 2.png");
  EXPECT_THAT(a.scale, ElementsAre(2, 3));
  EXPECT_THAT(a.offset, ElementsAre(0.5, 0));
  EXPECT_EQ(a.wraps.u, TextureWrap::kClamp);
  EXPECT_EQ(a.wraps.v, TextureWrap::kClamp);
}

TEST(MtlReader, TheAmbientOrGivenLightIsThePictureWhereThereIsNoOther) {
  const auto picture_of = [](const std::string& statements) {
    return materials_of("newmtl a\n" + statements).materials[0].picture;
  };
  EXPECT_EQ(picture_of("map_Ka a.png\n"), "a.png");
  EXPECT_EQ(picture_of("map_Ke e.png\n"), "e.png");
  EXPECT_EQ(picture_of("map_Kd d.png\nmap_Ka a.png\nmap_Ke e.png\n"), "d.png");
  EXPECT_EQ(picture_of("map_Ke e.png\nmap_Ka a.png\nmap_Kd d.png\n"), "d.png");
  EXPECT_EQ(picture_of("map_Ks s.png\n"), "");
  EXPECT_EQ(materials_of("newmtl a\nmap_Kd d.png\nnewmtl b\nmap_Ka b.png\n").materials[1].picture,
            "b.png");
}

TEST(MtlReader, ACommentMayFollowAName) {
  const auto picture_of = [](const std::string& name) {
    return materials_of("newmtl a\nmap_Kd " + name + "\n").materials[0].picture;
  };
  EXPECT_EQ(picture_of("skin.png # by hand"), "skin.png");
  EXPECT_EQ(picture_of("skin.png\t#by hand"), "skin.png");
  EXPECT_EQ(picture_of("my skin.jpeg # 1 # 2"), "my skin.jpeg");
  EXPECT_EQ(picture_of("wall #2.png"), "wall #2.png");
  EXPECT_EQ(picture_of("wall #2.png # second"), "wall #2.png");
  EXPECT_EQ(picture_of("wall.png#2"), "wall.png#2");
}

TEST(MtlReader, PicturesOfAllStatementsAreListedOnce) {
  const MaterialFile file = materials_of(
      "newmtl a\nmap_Kd a.png\nmap_Bump -bm 0.3 n.png\nbump n.png\nmap_aat on\nrefl -type sphere "
      "r.png\ndisp \"d.png\"\nnewmtl b\nmap_Kd a.png\nmap_Ks\n");
  EXPECT_THAT(file.pictures, ElementsAre("a.png", "n.png", "r.png", "d.png"));
}

TEST(MtlReader, TextsThatAreNotMaterialsAreSkipped) {
  EXPECT_TRUE(materials_of("Kd 1 1 1\nmap_Kd -s\nnonsense\n").materials.empty());
  EXPECT_EQ(materials_of("newmtl a\nKd nan 1 1\n").materials[0].diffuse, std::nullopt);
}

TEST(MtlReader, AFileAboveTheLimitIsRefused) {
  const auto file = read(std::string(kMaterialFileBytesMax + 1, '\n'));
  EXPECT_THAT(file.status().message(), testing::HasSubstr(std::to_string(kMaterialFileBytesMax)));
}

}  // namespace
}  // namespace burnish
