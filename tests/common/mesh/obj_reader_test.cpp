#include "tests/common/mesh/reading.h"

namespace burnish {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr MeshFormat kObj = MeshFormat::kObj;
const std::string kObjSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST(ObjReader, ReadsPolygonsInEveryCornerForm) {
  const std::string content =
      "# a square\nmtllib m.mtl\no square\n" + kObjSquare +
      "vt 0 0\nvn 0 0 1\ng one\nusemtl red\ns 1\n"
      "f 1 2 3 4\nf 1/1 2/1 3/1\nf 1//1 2//1 3//1\nf 1/1/1 2/1/1 4/1/1 # the last\nl 1 2\n";
  for (const std::string& text : {content, with_crlf(content), "\xEF\xBB\xBF" + content}) {
    const TriangleMesh mesh = parsed(kObj, text);
    EXPECT_THAT(mesh.vertices,
                ElementsAre(Vec3d(0, 0, 0), Vec3d(1, 0, 0), Vec3d(1, 1, 0), Vec3d(0, 1, 0)));
    EXPECT_THAT(mesh.triangles, ElementsAre(Triangle{0, 1, 2}, Triangle{0, 2, 3}, Triangle{0, 1, 2},
                                            Triangle{0, 1, 2}, Triangle{0, 1, 3}));
    EXPECT_FALSE(mesh.has_colours());
    EXPECT_FALSE(mesh.has_double_positions);
  }
}

TEST(ObjReader, NegativeIndicesCountBackFromTheLastVertex) {
  const TriangleMesh mesh = parsed(kObj, kObjSquare + "f -4 -3 -2\nv 5 5 5\nf -4/-1 -3/-1 -1/-1");
  EXPECT_THAT(mesh.triangles, ElementsAre(Triangle{0, 1, 2}, Triangle{1, 2, 4}));
}

TEST(ObjReader, FacesMayComeBeforeTheirVertices) {
  EXPECT_THAT(parsed(kObj, "f 1 2 3\n" + kObjSquare).triangles, ElementsAre(Triangle{0, 1, 2}));
}

TEST(ObjReader, BackslashContinuesALine) {
  const TriangleMesh mesh = parsed(
      kObj, with_crlf("# not this one: C:\\\nv 0 \\\n0 \\\n 0\nv 1 0 0\nv 1 1 0\nf 1\\\n2 3"));
  EXPECT_EQ(mesh.vertices.size(), 3u);
  EXPECT_THAT(mesh.triangles, ElementsAre(Triangle{0, 1, 2}));
}

TEST(ObjReader, KeepsColoursAsFractionsOrBytes) {
  const std::string rest = "v 1 0 0 0 0 0\nv 0 1 0\nf 1 2 3\n";
  EXPECT_THAT(parsed(kObj, "v 0 0 0 1 0.5 0\n" + rest).colours,
              ElementsAre(Rgba8{255, 128, 0, 255}, Rgba8{0, 0, 0, 255}, Rgba8{255, 255, 255, 255}));
  EXPECT_THAT(parsed(kObj, "v 0 0 0 255 1 300\n" + rest).colours,
              ElementsAre(Rgba8{255, 1, 255, 255}, Rgba8{0, 0, 0, 255}, Rgba8{255, 255, 255, 255}));
  EXPECT_FALSE(parsed(kObj, "v 0 0 0 1.0\nv 1 0 0 1.0\nv 0 1 0 1.0\nf 1 2 3\n").has_colours());
}

TEST(ObjReader, KnowsWhenPositionsSayMoreThanFloats) {
  const auto is_double = [](const std::string& x) {
    return parsed(kObj, "v " + x + " 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").has_double_positions;
  };
  EXPECT_TRUE(is_double("512345.678"));
  EXPECT_TRUE(is_double("0.1234567890123"));
  EXPECT_TRUE(is_double("1.234567890123e+02"));
  EXPECT_FALSE(is_double("0.1"));
  EXPECT_FALSE(is_double("-0.49023438"));  // the shortest text of a float
  EXPECT_FALSE(is_double("1.6777216e+07"));
  EXPECT_FALSE(is_double("0.5000000000000000"));
}

TEST(ObjReader, RefusesBadCoordinates) {
  EXPECT_THAT(refusal(kObj, "v 0 0 0\nv 1 0\n"),
              HasSubstr("scan: line 2: vertex 1 has 2 of its 3 coordinates"));
  EXPECT_THAT(refusal(kObj, "v 0 zero 0\n"), HasSubstr("vertex 0: y = 'zero' is not a number"));
  EXPECT_THAT(refusal(kObj, "v 0 0 1e999\n"), HasSubstr("vertex 0: z = '1e999' is not a number"));
  const auto used = [](const std::string& vertex) {
    return refusal(kObj, "v 0 0 0\nv 1 0 0\n" + vertex + "\nv 0 1 0\nf 1 2 4\nf 3 1 2\n");
  };
  EXPECT_THAT(used("v nan 0 0"),
              HasSubstr("line 3: vertex 2: x = nan; coordinates must be finite"));
  EXPECT_THAT(used("v 0 -inf 0"), HasSubstr("y = -inf; coordinates must be finite"));
  EXPECT_THAT(used("v 0 0 1e30"), HasSubstr("z = 1e30; coordinates must be finite and"));
}

TEST(ObjReader, CarriesVerticesWithoutPlaceThatNoFaceUses) {
  const TriangleMesh mesh = parsed(
      kObj,
      "v nan nan nan\nv 7 0 0\nv 8 0 0\nv 7 1 0\nv 1.#QNAN 3 -1.#IND\nv 1e30 inf 5\nf 2 3 4\n");
  EXPECT_THAT(mesh.vertices, testing::ElementsAre(Vec3d(7, 0, 0), Vec3d(7, 0, 0), Vec3d(8, 0, 0),
                                                  Vec3d(7, 1, 0), Vec3d(7, 3, 0), Vec3d(7, 0, 5)));
}

TEST(ObjReader, ThousandsOfVerticesWithoutPlaceHideNoneThatIsUsed) {
  std::string content;
  for (int v = 0; v < 3000; ++v) content += "v nan 0 0\n";
  content += "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  EXPECT_EQ(parsed(kObj, content + "f -1 -2 -3\n").vertices[2999], Vec3d(0, 0, 0));
  EXPECT_THAT(refusal(kObj, content + "f -1 -2 -3\nf -1 -2 2500\n"),
              HasSubstr("vertex 2499: coordinates must be finite"));
}

TEST(ObjReader, FacesOfOneOrTwoCornersAreCarried) {
  EXPECT_EQ(parsed(kObj, kObjSquare + "f 1 2\nf 3\nf\nf 1 2 3\nf 2 3\n").triangles,
            parsed(kObj, kObjSquare + "f 1 2 3\n").triangles);
  EXPECT_THAT(refusal(kObj, kObjSquare + "f 1 2\n"), HasSubstr("mesh has no triangles"));
  EXPECT_THAT(refusal(kObj, kObjSquare + "f 1 2 3\nf 1 9\n"), HasSubstr("refers to vertex 9"));
}

TEST(ObjReader, LinesMayEndInCr) {
  const std::string content = "# c\n" + kObjSquare + "f 1 2 \\\n3\nf 1 3 4\n";
  const TriangleMesh mesh = parsed(kObj, content);
  for (const std::string& text : {with_cr(content), with_crlf(content),
                                  with_cr(content.substr(0, 20)) + content.substr(20)}) {
    EXPECT_EQ(parsed(kObj, text).vertices, mesh.vertices);
    EXPECT_EQ(parsed(kObj, text).triangles, mesh.triangles);
  }
  EXPECT_THAT(refusal(kObj, with_cr(kObjSquare + "f 1 2 x\n")), HasSubstr("line 5: face 0"));
}

TEST(ObjReader, ALongTextOfCrIsReadInOnePass) {
  std::string content = kObjSquare;
  while (content.size() < (3 << 20)) content += "v 0 0 0\n";
  EXPECT_EQ(parsed(kObj, with_cr(content + "f 1 2 3\n")).triangles.size(), 1u);
  const std::string overlong = with_cr(content) + std::string((1 << 20) + 1, '#') + "\rf 1 2 3\r";
  EXPECT_THAT(refusal(kObj, overlong), HasSubstr("has 1048577 bytes, the limit is 1048576"));
}

TEST(ObjReader, RefusesBadCorners) {
  const auto refused = [](const std::string& face) { return refusal(kObj, kObjSquare + face); };
  EXPECT_THAT(refused("f 1 2 0\n"), HasSubstr("refers to vertex 0; OBJ counts vertices from 1"));
  EXPECT_THAT(refused("f 1 2 3\nf 1 2 x/1\n"), HasSubstr("line 6: face 1 refers to 'x/1'"));
  EXPECT_THAT(refused("f 1 2 -5\n"), HasSubstr("refers to vertex -5, but only 4 come before it"));
  EXPECT_THAT(refused("f 1 2 3\nf 1 2 5\nf 1 2 3\n"),
              HasSubstr("line 6: face 1 refers to vertex 5, but there are 4"));
  EXPECT_THAT(refused("f 1 2 4294967298\n"),
              HasSubstr("refers to vertex 4294967298, the limit is 2147483648"));
  EXPECT_THAT(refused("f 1 2 -9223372036854775808\n"), HasSubstr("vertex -9223372036854775808"));
}

TEST(ObjReader, RefusesFilesWithoutFaces) {
  EXPECT_THAT(refusal(kObj, ""), HasSubstr("scan: the file is empty"));
  EXPECT_THAT(refusal(kObj, kObjSquare), HasSubstr("scan: mesh has no triangles"));
  EXPECT_THAT(refusal(kObj, "not a mesh at all"), HasSubstr("scan: mesh has no triangles"));
  EXPECT_THAT(refusal(kObj, "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n"), HasSubstr("no area"));
}

TEST(ObjReader, RefusesOverlongLines) {
  EXPECT_THAT(refusal(kObj, kObjSquare + std::string(1 << 20, '#') + "x\nf 1 2 3\n"),
              HasSubstr("line 5 has 1048577 bytes, the limit is 1048576"));
}

}  // namespace
}  // namespace burnish
