#include "common/mesh/rewrite/left_out/left_out.h"

#include "tests/common/archive/packing.h"
#include "tests/common/gltf/glb_file.h"
#include "tests/common/mesh/reading.h"
#include "tests/common/temporary_folder.h"

namespace burnish {
namespace {

std::string left_out(MeshFormat format, const std::string& content, MeshFormat to) {
  TemporaryFolder folder;
  const auto names = attributes_left_out({folder.write("scan", content), format, "scan"}, to,
                                         parsed(format, content));
  EXPECT_TRUE(names.is_ok()) << names.status().message();
  return names.is_ok() ? left_out_text(*names) : "";
}

const std::string kObjWithAll =
    "# made\nmtllib m.mtl\no a\nv 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv 1 1 0 1 0 0\nv 0 1 0 1 0 0\n"
    "vt 0 0\nvn 0 0 1\ns 1\nusemtl m\nf 1/1/1 2/1/1 3/1/1 4/1/1\nl 1 2\n";

TEST(LeftOut, AnObjNamesItsStatementsOnce) {
  EXPECT_EQ(left_out(MeshFormat::kObj, kObjWithAll, MeshFormat::kPly),
            "materials, groups, texture coordinates, normals, smoothing groups, lines and points, "
            "polygons, comments");
  EXPECT_THAT(left_out(MeshFormat::kObj, kObjWithAll, MeshFormat::kStl),
              testing::EndsWith(", colours"));
}

TEST(LeftOut, ItsOwnFormatLeavesNothingOut) {
  EXPECT_EQ(left_out(MeshFormat::kObj, kObjWithAll, MeshFormat::kObj), "");
}

TEST(LeftOut, APlainMeshLeavesNothingOut) {
  EXPECT_EQ(left_out(MeshFormat::kObj, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", MeshFormat::kPly),
            "");
  EXPECT_EQ(
      left_out(MeshFormat::kOff, "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", MeshFormat::kPly),
      "");
}

std::string ply_with(const std::string& vertex_properties, const std::string& values) {
  std::string text = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n";
  text += "property float y\nproperty float z\n" + vertex_properties + "element face 1\n";
  text += "property list uchar int vertex_indices\nend_header\n";
  for (const char* position : {"0 0 0", "1 0 0", "0 1 0"}) text += position + values + "\n";
  return text + "3 0 1 2\n";
}

TEST(LeftOut, APlyNamesItsPropertiesAndElements) {
  const std::string file = ply_with(
      "property float nx\nproperty float ny\nproperty float nz\nproperty float s\n"
      "property float t\nproperty float quality\nproperty uchar red\n"
      "property uchar green\nproperty uchar blue\nproperty uchar alpha\n",
      " 0 0 1 0 0 5 1 2 3 4");
  EXPECT_EQ(left_out(MeshFormat::kPly, file, MeshFormat::kObj),
            "normals, texture coordinates, property 'quality', transparency");
}

TEST(LeftOut, APlyNamesNormalsOfFacesAndKnowsOtherNamesOfColours) {
  std::string file = ply_with(
      "property uchar diffuse_red\nproperty uchar diffuse_green\nproperty uchar diffuse_blue\n",
      " 1 2 3");
  EXPECT_EQ(left_out(MeshFormat::kPly, file, MeshFormat::kObj), "");
  file.insert(file.find("end_header"), "property float nx\nproperty float ny\nproperty float nz\n");
  file.insert(file.size() - 1, " 0 0 1");
  EXPECT_EQ(left_out(MeshFormat::kPly, file, MeshFormat::kObj), "normals of faces");
}

TEST(LeftOut, AHostileHeaderGivesAShortList) {
  std::string properties, values;
  for (int i = 0; i < 200; ++i) {
    properties += "property int p" + std::to_string(i) + "\n";
    values += " 0";
  }
  const std::string list =
      left_out(MeshFormat::kPly, ply_with(properties, values), MeshFormat::kStl);
  EXPECT_EQ(std::count(list.begin(), list.end(), ','), 19);
  EXPECT_THAT(list, testing::EndsWith(", others"));
}

TEST(LeftOut, AnOffNamesNormalsTextureCoordinatesAndPolygons) {
  const std::string file =
      "STNOFF\n4 1 0\n0 0 0 0 0 1 0 0\n1 0 0 0 0 1 0 0\n1 1 0 0 0 1 0 0\n0 1 0 0 0 1 0 0\n"
      "4 0 1 2 3\n";
  EXPECT_EQ(left_out(MeshFormat::kOff, file, MeshFormat::kObj),
            "normals, texture coordinates, polygons");
}

TEST(LeftOut, AGlbNamesItsAttributesAndItsScene) {
  GlbFile file = square_glb();
  EXPECT_EQ(left_out(MeshFormat::kGlb, file.glb(), MeshFormat::kPly), "");
  TestJson attributes = {{"POSITION", 0}, {"NORMAL", 0}, {"TANGENT", 0}, {"TEXCOORD_1", 0}};
  attributes["_QUALITY"] = 0;
  file.json["meshes"][0]["primitives"][0]["attributes"] = attributes;
  file.add_primitive({{"POSITION", 0}})["mode"] = 1;
  for (const char* list : {"materials", "textures", "images", "cameras", "animations"})
    file.json[list] = {{{"name", "a"}}};
  file.json["nodes"].push_back({{"name", "b"}});
  for (const auto& [format, content] :
       {std::pair(MeshFormat::kGlb, file.glb()), std::pair(MeshFormat::kGltf, file.gltf())})
    EXPECT_EQ(left_out(format, content, MeshFormat::kPly),
              "normals, texture coordinates, attribute _QUALITY, lines and points, materials, "
              "textures, pictures, cameras, animations, nodes and their names");
}

TEST(LeftOut, AGlbTakesColoursAndTransparency) {
  const std::string ply = ply_with(
      "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty uchar alpha\n",
      " 1 2 3 4");
  EXPECT_EQ(left_out(MeshFormat::kPly, ply, MeshFormat::kGlb), "");
}

TEST(LeftOut, AnStlNamesAttributesOfFacets) {
  std::string file(80, ' ');
  file += bytes_of(uint32_t{1}, 0.F, 0.F, 1.F) + bytes_of(0.F, 0.F, 0.F, 1.F, 0.F, 0.F);
  file += bytes_of(0.F, 1.F, 0.F);
  EXPECT_EQ(left_out(MeshFormat::kStl, file + bytes_of(uint16_t{0}), MeshFormat::kPly), "");
  EXPECT_EQ(left_out(MeshFormat::kStl, file + bytes_of(uint16_t{9}), MeshFormat::kPly),
            "attributes of facets");
}

TEST(LeftOut, AGltfsDataBesideItIsNotLeftOut) {
  GlbFile file = square_glb();
  file.json["images"] = {{{"uri", "skin.png"}}};
  TestJson json = file.json;
  json["buffers"] = {{{"byteLength", file.bin.size()}, {"uri", "data/scan.bin"}}};
  const auto archive = as_string(packed(
      {{"a/skin.png", "pixels"}, {"a/data/scan.bin", file.bin}, {"a/scan.gltf", json.dump()}}));
  EXPECT_EQ(left_out(MeshFormat::kZip, archive, MeshFormat::kPly), "pictures");
  const TemporaryFolder folder;
  const OriginalFile alone = {folder.write("scan.gltf", json.dump()), MeshFormat::kGltf, "scan"};
  const auto names =
      attributes_left_out(alone, MeshFormat::kPly, parsed(MeshFormat::kZip, archive));
  ASSERT_TRUE(names.is_ok()) << names.status().message();
  EXPECT_EQ(left_out_text(*names), "pictures");
}

TEST(LeftOut, APlyKeepsChangedColoursWhereItHasColoursAndNotThoseOfItsTextures) {
  const std::string begin =
      "ply\nformat ascii 1.0\ncomment TextureFile skin.png\nelement vertex 3\n"
      "property float x\nproperty float y\nproperty float z\n";
  const std::string end =
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
      "0 0 0 1 2 3\n1 0 0 1 2 3\n0 1 0 1 2 3\n3 0 1 2\n";
  const auto keeps = [&](const std::string& properties, MeshFormat to) {
    const TemporaryFolder folder;
    const auto path = folder.write("scan.ply", begin + properties + end);
    return keeps_changed_colours({path, MeshFormat::kPly, "scan"}, to).value();
  };
  const char* colours = "property uchar red\nproperty uchar green\nproperty uchar blue\n";
  const char* others = "property uchar s\nproperty uchar t\nproperty uchar q\n";
  EXPECT_TRUE(keeps(colours, MeshFormat::kPly));
  EXPECT_FALSE(keeps(others, MeshFormat::kPly));
  EXPECT_TRUE(keeps(others, MeshFormat::kObj));
}

}  // namespace
}  // namespace burnish
