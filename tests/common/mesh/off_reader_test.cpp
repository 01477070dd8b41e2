#include "tests/common/mesh/reading.h"

namespace burnish {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr MeshFormat kOff = MeshFormat::kOff;
const std::string kOffSquare = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";

TEST(OffReader, ReadsCountsOnTheFirstLineOrTheNext) {
  for (const std::string start :
       {"OFF\n4 2 0\n", "OFF 4 2\n", "# c\n\nOFF # c\n# c\n\n4 2 5 # c\n"}) {
    const std::string content = start + kOffSquare + "# faces\n4 0 1 2 3 255 0 0\n3 1 1 2";
    for (const std::string& text :
         {content, with_crlf(content), with_cr(content), content + "\nnoise\n"}) {
      const TriangleMesh mesh = parsed(kOff, text);
      EXPECT_THAT(mesh.vertices,
                  ElementsAre(Vec3d(0, 0, 0), Vec3d(1, 0, 0), Vec3d(1, 1, 0), Vec3d(0, 1, 0)));
      EXPECT_THAT(mesh.triangles,
                  ElementsAre(Triangle{0, 1, 2}, Triangle{0, 2, 3}, Triangle{1, 1, 2}));
    }
  }
}

TEST(OffReader, KeepsVertexColours) {
  const std::string faces = "3 0 1 2\n";
  EXPECT_THAT(
      parsed(kOff, "COFF\n3 1 0\n0 0 0 255 0 7 255\n1 0 0 1 2 3 255\n0 1 0 9 9 9 255\n" + faces)
          .colours,
      ElementsAre(Rgba8{255, 0, 7, 255}, Rgba8{1, 2, 3, 255}, Rgba8{9, 9, 9, 255}));
  EXPECT_THAT(
      parsed(kOff,
             "CNOFF\n3 1 0\n0 0 0 0 0 1 1 0 .5\n1 0 0 0 0 1 0 0 0\n0 1 0 0 0 1 0 0 0\n" + faces)
          .colours,
      ElementsAre(Rgba8{255, 0, 128, 255}, Rgba8{0, 0, 0, 255}, Rgba8{0, 0, 0, 255}));
  EXPECT_FALSE(
      parsed(kOff, "NOFF\n3 1 0\n0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n" + faces).has_colours());
}

TEST(OffReader, GoesByWords) {
  const TriangleMesh expected = parsed(kOff, "OFF\n4 2 0\n" + kOffSquare + "4 0 1 2 3\n3 1 1 2\n");
  for (const std::string& content :
       {"OFF4 2 0\n" + kOffSquare + "4 0 1 2 3\n3 1 1 2\n",      // no blank behind OFF
        "OFF\n4 2 0\n" + kOffSquare + "4\n0 1\n2 3\n3 1 1 2\n",  // a face on three lines
        std::string("OFF\n4 2 0\n0\n0 0\n1 0\n0\n1 1 0\n0 1 0\n4 0 1 2 3\n3 1 1 2\n"),
        std::string("OFF\n4\n2\n0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n3 1 1 2\n"),
        std::string("OFF 4 2 0 0 0 0 1 0 0 1 1 0\n0 1 0 4 0 1 2 3 3 1 1 2")}) {
    const TriangleMesh mesh = parsed(kOff, content);
    EXPECT_EQ(mesh.vertices, expected.vertices) << content;
    EXPECT_EQ(mesh.triangles, expected.triangles) << content;
  }
  EXPECT_EQ(
      parsed(kOff, "NOFF\n3 1 0\n0 0 0\n0 0 1\n1 0 0\n0 0 1\n0 1 0\n0 0 1\n3 0 1 2\n").vertices[2],
      Vec3d(0, 1, 0));
}

TEST(OffReader, NumbersBehindAnElementOfALineAreNotTheNextElement) {
  const TriangleMesh mesh = parsed(
      kOff, "OFF\n3 2 0\n0 0 0 9 9 9\n1 0 0 9 9 9\n0 1 0 9 9 9\n3 0 1 2 255 0 0\n3 2 1 0 0.5\n");
  EXPECT_EQ(mesh.vertices[1], Vec3d(1, 0, 0));
  EXPECT_THAT(mesh.triangles, ElementsAre(Triangle{0, 1, 2}, Triangle{2, 1, 0}));
}

TEST(OffReader, KnowsWhenPositionsSayMoreThanFloats) {
  EXPECT_TRUE(
      parsed(kOff, "OFF\n3 1 0\n512345.678 0 0\n1 0 0\n0 1 0\n3 0 1 2\n").has_double_positions);
  EXPECT_FALSE(parsed(kOff, "OFF\n3 1 0\n0.1 0 0\n1 0 0\n0 1 0\n3 0 1 2\n").has_double_positions);
}

TEST(OffReader, RefusesWhatIsNoTextOff) {
  EXPECT_THAT(refusal(kOff, ""), HasSubstr("scan: the file is empty"));
  EXPECT_THAT(refusal(kOff, "\n\n"), HasSubstr("not an OFF file: begins with ''"));
  EXPECT_THAT(refusal(kOff, "ply\n"), HasSubstr("line 1: not an OFF file: begins with 'ply'"));
  EXPECT_THAT(refusal(kOff, "4OFF\n1 1 0\n"), HasSubstr("begins with '4OFF'"));
  EXPECT_THAT(refusal(kOff, "OFF BINARY\n"), HasSubstr("binary OFF files cannot be read"));
}

TEST(OffReader, RefusesBadCounts) {
  EXPECT_THAT(refusal(kOff, "OFF\n"), HasSubstr("the vertex count '' is not a count"));
  EXPECT_THAT(refusal(kOff, "OFF\nfour 1 0\n"), HasSubstr("line 2: the vertex count 'four'"));
  EXPECT_THAT(refusal(kOff, "OFF\n4\n"), HasSubstr("the face count '' is not a count"));
  EXPECT_THAT(refusal(kOff, "OFF\n-4 1 0\n"),
              HasSubstr("the vertex count -4 is outside 0 to 2147483648"));
  EXPECT_THAT(refusal(kOff, "OFF\n4 3000000000 0\n"), HasSubstr("the face count 3000000000 is"));
  EXPECT_THAT(refusal(kOff, "OFF\n2000000000 1 0\n" + kOffSquare),
              HasSubstr("promises 2000000000 vertices and 1 faces, at least 12000000001 bytes, "
                        "but only 24 follow"));
}

TEST(OffReader, TruncatedFilesNameWhatIsMissing) {
  const std::string content = "OFF\n4 2 0\n" + kOffSquare + "3 0 1 2  \n3 0 2 3";
  EXPECT_THAT(refusal(kOff, content.substr(0, content.size() - 7)),
              HasSubstr("line 7: the file ends before face 1 of 2"));
  EXPECT_THAT(refusal(kOff, "OFF\n4 1 0\n" + kOffSquare.substr(0, 18) + "      \n"),
              HasSubstr("the file ends before vertex 3 of 4"));
  EXPECT_THAT(refusal(kOff, content.substr(0, content.size() - 2)),
              HasSubstr("line 8: face 1 has 2 of its 3 corners"));
  for (size_t length = 0; length < content.size(); ++length)
    EXPECT_FALSE(parse(kOff, content.substr(0, length)).is_ok()) << length << " bytes";
}

TEST(OffReader, RefusesBadFaces) {
  const auto refused = [](const std::string& face) {
    return refusal(kOff, "OFF\n4 1 0\n" + kOffSquare + face + "\n");
  };
  EXPECT_THAT(refused("2 0 1"), HasSubstr("mesh has no triangles"));
  EXPECT_THAT(refused("-3 0 1 2"), HasSubstr("line 7: face 0: '-3' is not a number of corners"));
  EXPECT_THAT(refused("4000000000 0 1 2"), HasSubstr("face 0 has 3 of its 4000000000 corners"));
  EXPECT_THAT(refused("x 0 1 2"), HasSubstr("face 0: 'x' is not a number of corners"));
  EXPECT_THAT(refused("3 0 1 4"),
              HasSubstr("face 0 refers to vertex 4, but there are 4, numbered from 0"));
  EXPECT_THAT(refused("3 0 1 -1"), HasSubstr("face 0 refers to vertex -1"));
  EXPECT_THAT(refused("3 0 1 b"), HasSubstr("face 0: 'b' is not a vertex number"));
}

TEST(OffReader, RefusesBadCoordinates) {
  const auto refused = [](const std::string& vertex) {
    return refusal(kOff, "OFF\n4 1 0\n0 0 0\n" + vertex + "\n1 1 0\n0 1 0\n3 0 2 1\n");
  };
  EXPECT_THAT(refused("1 0"), HasSubstr("line 4: vertex 1 has 2 of its 3 coordinates"));
  EXPECT_THAT(refused("1 a 0"), HasSubstr("vertex 1: y = 'a' is not a number"));
  EXPECT_THAT(refused("1 0 nan"),
              HasSubstr("line 4: vertex 1: z = nan; coordinates must be finite"));
  EXPECT_THAT(refused("inf 0 0"), HasSubstr("vertex 1: x = inf"));
  EXPECT_THAT(refused("-1e19 0 0"), HasSubstr("vertex 1: x = -1e19"));
}

TEST(OffReader, CarriesFacesWithoutAreaAndVerticesWithoutPlace) {
  const TriangleMesh mesh =
      parsed(kOff, "OFF\n4 3 0\n1 0 0\nnan 5 -inf\n1 1 0\n0 1 0\n2 0 1\n3 0 2 3\n0\n");
  EXPECT_THAT(mesh.triangles, ElementsAre(Triangle{0, 2, 3}));
  EXPECT_EQ(mesh.vertices[1], Vec3d(1, 5, 0));
}

TEST(OffReader, RefusesFilesWithoutFacesAndOverlongLines) {
  EXPECT_THAT(refusal(kOff, "OFF\n4 0 0\n" + kOffSquare), HasSubstr("mesh has no triangles"));
  EXPECT_THAT(refusal(kOff, "OFF\n" + std::string((1 << 20) + 1, ' ') + "\n4 0 0\n"),
              HasSubstr("line 2 has 1048577 bytes, the limit is 1048576"));
}

}  // namespace
}  // namespace burnish
