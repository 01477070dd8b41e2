#include <limits>

#include "tests/common/mesh/reading.h"

namespace burnish {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr MeshFormat kStl = MeshFormat::kStl;

const std::string kFacet =
    "facet normal nan nan nan\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nendloop\n"
    "endfacet\n";
const std::string kOtherFacet =
    "facet normal 0 0 1\n outer loop\n  vertex 0 0 0\n  vertex 1 1 -0\n  vertex 0 1 0\n endloop\n"
    "endfacet\n";

std::string binary_facet(float x) {
  return bytes_of(0.F, 0.F, 1.F, x, 0.F, 0.F, 1.F, 0.F, -0.F, 1.F, 1.F, 0.F, uint16_t{7});
}

std::string binary(std::string title, uint32_t count, const std::string& facets) {
  title.resize(80, ' ');
  return title + bytes_of(count) + facets;
}

TEST(StlReader, WeldsEqualPositions) {
  const std::string content = "solid s\n" + kFacet + kOtherFacet + "endsolid s\n";
  for (const std::string& text : {content, with_crlf(content), with_cr(content),
                                  content.substr(0, content.size() - 1), content + "noise\n"}) {
    const TriangleMesh mesh = parsed(kStl, text);
    EXPECT_THAT(mesh.vertices,
                ElementsAre(Vec3d(0, 0, 0), Vec3d(1, 0, 0), Vec3d(1, 1, 0), Vec3d(0, 1, 0)));
    EXPECT_THAT(mesh.triangles, ElementsAre(Triangle{0, 1, 2}, Triangle{0, 2, 3}));
  }
}

TEST(StlReader, ReadsSeveralSolidsInAnyCase) {
  const TriangleMesh mesh = parsed(
      kStl, "SOLID\n" + kFacet + "ENDSOLID\n\n# between\nSolid two\n" + kOtherFacet + "EndSolid");
  EXPECT_EQ(mesh.vertices.size(), 4u);
  EXPECT_EQ(mesh.triangles.size(), 2u);
}

TEST(StlReader, EndMayBeAWordOfItsOwn) {
  std::string content = "solid s\n" + kFacet + kOtherFacet + "endsolid s\n";
  for (size_t at = 0; (at = content.find("end", at)) != std::string::npos; at += 4)
    content.insert(at + 3, content.compare(at, 4, "endf") == 0 ? "  " : " ");
  ASSERT_NE(content.find("end loop\nend  facet"), std::string::npos);
  EXPECT_EQ(parsed(kStl, content).triangles.size(), 2u);
  EXPECT_EQ(parsed(kStl, content + "solid t\n" + kFacet + "End Solid\n").triangles.size(), 3u);
  EXPECT_THAT(refusal(kStl, "solid s\n" + kFacet + "end game\n"),
              HasSubstr("'endgame' is not a statement of an STL solid"));
}

TEST(StlReader, ReadsBinaryAndWeldsThousandsOfFacets) {
  std::string facets;
  for (int i = 0; i < 3000; ++i) facets += binary_facet(static_cast<float>(i % 1500) - 2000);
  const TriangleMesh mesh = parsed(kStl, binary("scan", 3000, facets));
  EXPECT_EQ(mesh.vertices.size(), 1502u);
  EXPECT_EQ(mesh.triangles.size(), 3000u);
  EXPECT_EQ(mesh.triangles[1], mesh.triangles[1501]);
  EXPECT_FALSE(mesh.has_double_positions);
}

TEST(StlReader, ABinaryFileMayBeginWithSolid) {
  EXPECT_EQ(parsed(kStl, binary("solid part", 1, binary_facet(0))).triangles.size(), 1u);
  EXPECT_EQ(parsed(kStl, binary("solid part", 1, binary_facet(0)) + "more").triangles.size(), 1u);
}

TEST(StlReader, KnowsWhenPositionsSayMoreThanFloats) {
  std::string content = "solid s\n" + kFacet + "endsolid s\n";
  EXPECT_FALSE(parsed(kStl, content).has_double_positions);
  content.replace(content.find("vertex 1 0 0"), 12, "vertex 512345.678 0 0");
  EXPECT_TRUE(parsed(kStl, content).has_double_positions);
}

TEST(StlReader, RefusesWhatIsNoStlFile) {
  EXPECT_THAT(refusal(kStl, ""), HasSubstr("scan: the file is empty"));
  EXPECT_THAT(
      refusal(kStl, "ply\n"),
      HasSubstr("scan: neither text that begins with 'solid' nor a whole binary STL file: the "
                "header has 84 bytes, the file has 4"));
  EXPECT_THAT(refusal(kStl, "solid s\nendsolid s\n"), HasSubstr("mesh has no triangles"));
  EXPECT_THAT(refusal(kStl, binary("b", 0, "")), HasSubstr("mesh has no triangles"));
}

TEST(StlReader, BinaryCountsAreCheckedAgainstTheFile) {
  EXPECT_THAT(refusal(kStl, binary("b", 0xFFFFFFFF, binary_facet(0))),
              AllOf(HasSubstr("promises 4294967295 facets, 214748364834 bytes"),
                    HasSubstr("the file has 134; facet 1 is not complete")));
  const std::string content = binary("solid b", 2, binary_facet(0) + binary_facet(-1));
  for (size_t length = 0; length < content.size(); ++length)
    EXPECT_FALSE(parse(kStl, content.substr(0, length)).is_ok()) << length << " bytes";
}

TEST(StlReader, RefusesBadBinaryCoordinates) {
  for (const float x :
       {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), 2e18F})
    EXPECT_THAT(refusal(kStl, binary("b", 2, binary_facet(0) + binary_facet(x))),
                AllOf(HasSubstr("scan: byte 146: facet 1: x = "),
                      HasSubstr("coordinates must be finite and within")));
}

TEST(StlReader, TruncatedTextIsRefusedWhereverItEnds) {
  const std::string content = "solid s\n" + kFacet + kOtherFacet + "endsolid";
  EXPECT_THAT(refusal(kStl, "solid s\n" + kFacet),
              HasSubstr("line 8: the file ends in facet 1 or without 'endsolid'"));
  for (size_t length = 0; length < content.size(); ++length)
    EXPECT_FALSE(parse(kStl, content.substr(0, length)).is_ok()) << length << " bytes";
}

TEST(StlReader, RefusesBadStatements) {
  const auto refused = [](const std::string& lines) {
    return refusal(kStl, "solid s\n" + lines + "endsolid s\n");
  };
  EXPECT_THAT(refused("facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nendloop\n"
                      "endfacet\n"),
              HasSubstr("line 7: facet 0 has 2 corners; a facet needs 3"));
  EXPECT_THAT(refused("facet\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nvertex 1 1 0\n"),
              HasSubstr("line 6: facet 0 has more than 3 corners"));
  EXPECT_THAT(refused("facet\nvertex 0 0 0\nfacet\n"),
              HasSubstr("line 4: facet 0 has no 'endfacet' before 'facet'"));
  EXPECT_THAT(refused("vortex 0 0 0\n"),
              HasSubstr("line 2: 'vortex' is not a statement of an STL solid"));
  EXPECT_THAT(refused("facet\nvertex 0 0\n"),
              HasSubstr("line 3: facet 0 has 2 of its 3 coordinates"));
  EXPECT_THAT(refused("facet\nvertex 0 0 up\n"), HasSubstr("facet 0: z = 'up' is not a number"));
  EXPECT_THAT(refused("facet\nvertex nan 0 0\n"), HasSubstr("facet 0: x = nan; coordinates must"));
  EXPECT_THAT(refused("facet\nvertex 0 0 1e40\n"), HasSubstr("facet 0: z = 1e40; coordinates"));
}

TEST(StlReader, RefusesOverlongLines) {
  EXPECT_THAT(refusal(kStl, "solid " + std::string(1 << 20, 'x') + "\n" + kFacet + "endsolid\n"),
              HasSubstr("line 1 has 1048582 bytes, the limit is 1048576"));
}

}  // namespace
}  // namespace burnish
