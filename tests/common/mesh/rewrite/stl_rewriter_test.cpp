#include "tests/common/mesh/rewrite/rewriting.h"

namespace burnish {
namespace {

const std::string kStlText =
    "solid two  facets\n  facet normal 0.0e+00 0 1.000000e+00\n    outer loop\n"
    "      vertex 0 0 0\n      vertex 1.0 0 0\n      vertex -0 1E0 0\n    endloop\n  endfacet\n"
    "  FACET NORMAL 0 0 0\n    outer loop\n      vertex 1.0 0 0\n      vertex 1 1 0\n"
    "      vertex 0 1 0\n    endloop\n  endfacet\nendsolid two  facets\nremark\n";

TEST(StlRewriter, AnUnmovedTextIsTheSameBytes) {
  EXPECT_EQ(rewritten(MeshFormat::kStl, kStlText), kStlText);
  const std::string crlf = with_crlf(kStlText);
  EXPECT_EQ(rewritten(MeshFormat::kStl, crlf), crlf);
}

TEST(StlRewriter, CornersOfSeveralFacetsMoveTogether) {
  const auto move = [](size_t v, const Vec3d& p) { return v == 1 ? Vec3d(2, 0, 0) : p; };
  const std::string text = rewritten(MeshFormat::kStl, kStlText, move);
  EXPECT_EQ(parsed(MeshFormat::kStl, text).vertices.size(), 4u);
  EXPECT_EQ(text.find("vertex 1.0 0 0"), std::string::npos);
  EXPECT_NE(text.find("vertex 2.0 0 0"), text.rfind("vertex 2.0 0 0"));
}

TEST(StlRewriter, NormalsOfATextTurnAndZeroNormalsStay) {
  const auto turn = [](size_t, const Vec3d& p) { return Vec3d(0, p[1], p[0]); };
  const std::string text = rewritten(MeshFormat::kStl, kStlText, turn);
  EXPECT_THAT(text, testing::HasSubstr("facet normal -1.0e+00 0 0.000000e+00\n"));
  EXPECT_THAT(text, testing::HasSubstr("FACET NORMAL 0 0 0\n"));
}

TEST(StlRewriter, EndMayBeAWordOfItsOwn) {
  std::string apart = kStlText;
  for (size_t at = 0; (at = apart.find("end", at)) != std::string::npos; at += 4)
    apart.insert(at + 3, " ");
  EXPECT_EQ(rewritten(MeshFormat::kStl, apart), apart);
  const auto turn = [](size_t, const Vec3d& p) { return Vec3d(0, p[1], p[0]); };
  EXPECT_THAT(rewritten(MeshFormat::kStl, with_cr(apart), turn),
              testing::HasSubstr("facet normal -1.0e+00 0 0.000000e+00\r"));
}

std::string binary_stl(const std::string& header) {
  std::string file = header;
  file.resize(80, ' ');
  file += bytes_of(uint32_t{2}, 0.F, 0.F, 1.F) + bytes_of(0.F, 0.F, 0.F, 1.F, 0.F, 0.F);
  file += bytes_of(-0.F, 1.F, 0.F, uint16_t{0x8123}) + bytes_of(0.F, 0.F, 0.F);
  file += bytes_of(1.F, 0.F, 0.F, 1.F, 1.F, 0.F, 0.F, 1.F, 0.F, uint16_t{7});
  return file;
}

TEST(StlRewriter, AnUnmovedBinaryIsTheSameBytes) {
  for (const char* header : {"COLOR=abcd", "solid but binary"}) {
    const std::string file = binary_stl(header);
    EXPECT_EQ(rewritten(MeshFormat::kStl, file), file);
    EXPECT_EQ(rewritten(MeshFormat::kStl, "x" + file.substr(1) + "tail"),
              "x" + file.substr(1) + "tail");
  }
}

TEST(StlRewriter, ABinaryKeepsItsHeaderAndAttributes) {
  const std::string file = binary_stl("COLOR=abcd");
  const auto turn = [](size_t, const Vec3d& p) { return Vec3d(0, p[1], p[0]); };
  std::string expected = file.substr(0, 84);
  expected += bytes_of(-1.F, 0.F, 0.F) + bytes_of(0.F, 0.F, 0.F, 0.F, 0.F, 1.F);
  expected += bytes_of(-0.F, 1.F, 0.F, uint16_t{0x8123}) + bytes_of(0.F, 0.F, 0.F);
  expected += bytes_of(0.F, 0.F, 1.F, 0.F, 1.F, 1.F, 0.F, 1.F, 0.F, uint16_t{7});
  EXPECT_EQ(rewritten(MeshFormat::kStl, file, turn), expected);
}

}  // namespace
}  // namespace burnish
