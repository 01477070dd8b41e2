#include "tests/common/mesh/rewrite/rewriting.h"

namespace burnish {
namespace {

const std::string kPlyText =
    "ply\nformat ascii 1.0\ncomment TextureFile stone.png\nobj_info scanned\n"
    "element camera 1\nproperty list uchar float pose\nproperty int id\n"
    "element vertex 4\nproperty float quality\nproperty float x\nproperty double nx\n"
    "property float y\nproperty double ny\nproperty float z\nproperty double nz\n"
    "property uchar red\nproperty uchar green\nproperty uchar blue\n"
    "property list uchar short tags\n"
    "element face 1\nproperty list uchar int vertex_indices\nproperty list uchar float texcoord\n"
    "element note 2\nproperty float n\nend_header\n"
    "3 1.0 2.0 3.0 7\n"
    "nan 0.0  0.0 0 0 +0.00 1.0   1 2 3 2 5 6\n"
    "0.1 1.0  0.0 0 0 0.00 1.0   1 2 3 0\n"
    "0.2 1.0e0  0.0 1 0 0.00 1.0   1 2 3 1 9\n"
    "0.3 0.0  0.0 1 0 0.00 1.0   1 2 3 0\n"
    "4 0 1 2 3 2 0.5 0.25\n"
    "-0\n1E+2\n";

TEST(PlyRewriter, AnUnmovedTextIsTheSameBytes) {
  EXPECT_EQ(rewritten(MeshFormat::kPly, kPlyText), kPlyText);
  const std::string crlf = with_crlf(kPlyText);
  EXPECT_EQ(rewritten(MeshFormat::kPly, crlf), crlf);
}

TEST(PlyRewriter, AMovedCoordinateIsAllThatChangesInATextWithoutNormals) {
  const std::string text =
      replaced(replaced(replaced(kPlyText, "double nx", "double ax"), "double ny", "double ay"),
               "double nz", "double az");
  const auto move = [](size_t v, const Vec3d& p) { return v == 2 ? Vec3d(1.25, p[1], p[2]) : p; };
  EXPECT_EQ(rewritten(MeshFormat::kPly, text, move), replaced(text, "1.0e0", "1.25e+00"));
}

TEST(PlyRewriter, AColourChangesInTheTypeOfItsChannel) {
  const std::string bytes = recoloured(MeshFormat::kPly, kPlyText, 1, {1, 200, 3, 255});
  EXPECT_EQ(bytes, replaced(kPlyText, "1.0   1 2 3 0\n0.2", "1.0   1 200 3 0\n0.2"));
  std::string floats = kPlyText;
  for (const char* channel : {"red", "green", "blue"})
    floats = replaced(floats, std::string("uchar ") + channel, std::string("float ") + channel);
  for (size_t at; (at = floats.find("   1 2 3 ")) != std::string::npos;)
    floats.replace(at, 9, "   1 0.5 0.25 ");
  EXPECT_THAT(recoloured(MeshFormat::kPly, floats, 2, {255, 128, 51, 255}),
              testing::HasSubstr("1.0   1 0.5 0.2 1 9\n"));
}

TEST(PlyRewriter, NormalsFollowTheSurface) {
  // Turns the square about the y axis: x becomes z.
  const auto turn = [](size_t, const Vec3d& p) { return Vec3d(0, p[1], p[0]); };
  const std::string text = rewritten(MeshFormat::kPly, kPlyText, turn);
  EXPECT_THAT(text, testing::HasSubstr("0.2 0.0e+00  -1.0 1 0 1.00 0.0   1 2 3 1 9\n"));
}

TEST(PlyRewriter, NormalsThatPointInwardsStayThere) {
  std::string inwards = kPlyText;
  for (size_t at; (at = inwards.find(" 1.0   1")) != std::string::npos;)
    inwards.replace(at, 4, " -1.0");
  const auto turn = [](size_t, const Vec3d& p) { return Vec3d(0, p[1], p[0]); };
  EXPECT_THAT(rewritten(MeshFormat::kPly, inwards, turn),
              testing::HasSubstr("0.2 0.0e+00  1.0 1 0 1.00 0.0   1 2 3 1 9\n"));
}

/// Two triangles that meet at an edge whose vertices stand twice: the first two have one normal at
/// their place, the others have two.
const std::string kSeamPly =
    "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\n"
    "property float z\nproperty float nx\nproperty float ny\nproperty float nz\n"
    "element face 2\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 0 0 0 1\n0 0 0 0 0 1\n0 1 0 0 0 1\n0 1 0 0.5 0 0.8660254\n"
    "1 0 0 0 0 1\n-1 0 0 0 0 1\n3 0 4 2\n3 1 3 5\n";

TEST(PlyRewriter, NormalsThatWereEqualAtOnePlaceStayEqualAndOthersKeepTheirCrease) {
  const auto fold = [](size_t v, const Vec3d& p) { return v == 5 ? Vec3d(-1, 0, -1) : p; };
  const std::string text = rewritten(MeshFormat::kPly, kSeamPly, fold);
  EXPECT_THAT(text, testing::HasSubstr("0 0 0 -0.4472136 0 0.8944272\n"
                                       "0 0 0 -0.4472136 0 0.8944272\n"
                                       "0 1 0 0 0 1\n0 1 0 -0.7071068 0 0.7071068\n"));
}

TEST(PlyRewriter, NormalsOfFacesFollowThem) {
  const std::string before =
      "ply\nformat ascii 1.0\nelement face 2\nproperty float nx\nproperty float ny\n"
      "property list uchar int vertex_indices\nproperty float nz\nproperty int mark\n"
      "element vertex 5\nproperty float x\nproperty float y\nproperty float z\n"
      "element note 1\nproperty int n\nend_header\n"
      "0 0 4 0 1 2 3 -1.0 7\n0.0 0 3 0 2 4 1 8\n"
      "0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 2 0\n5\n";
  EXPECT_EQ(rewritten(MeshFormat::kPly, before), before);
  const auto fold = [](size_t v, const Vec3d& p) { return v == 4 ? Vec3d(0, 1, 1) : p; };
  const std::string after = rewritten(MeshFormat::kPly, before, fold);
  EXPECT_EQ(after, replaced(replaced(before, "0.0 0 3 0 2 4 1 8",
                                     "0.5774 -0.5774 3 0 2 4 "
                                     "0.5774 8"),
                            "0 2 0\n5", "0 1 1\n5"));
}

TEST(PlyRewriter, AVertexWithoutPlaceKeepsItsBytes) {
  const std::string before =
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
      "property float z\nproperty float nx\nproperty float ny\nproperty float nz\nelement face 1\n"
      "property list uchar int vertex_indices\nend_header\n"
      "0 0 0 0 0 1\nnan -nan(ind) 7.0 nan nan nan\n1 0 0 0 0 1\n0 1 0 0 0 1\n3 0 2 3\n";
  EXPECT_EQ(rewritten(MeshFormat::kPly, before), before);
  const auto turn = [](size_t v, const Vec3d& p) { return v == 1 ? p : Vec3d(0, p[1], p[0]); };
  const std::string after = rewritten(MeshFormat::kPly, before, turn);
  EXPECT_THAT(after, testing::HasSubstr("\nnan -nan(ind) 7.0 nan nan nan\n0 0 1 -1 0 0\n"));
}

TEST(PlyRewriter, FloatColoursKeepTheRangeOfTheFile) {
  std::string floats =
      replaced(kPlyText, "0 0 0.00 1.0   1 2 3 0\n0.2", "0 0 0.00 1.0   1 255.0 3 0\n0.2");
  for (const char* channel : {"red", "green", "blue"})
    floats = replaced(floats, std::string("uchar ") + channel, std::string("float ") + channel);
  EXPECT_EQ(rewritten(MeshFormat::kPly, floats), floats);
  EXPECT_THAT(recoloured(MeshFormat::kPly, floats, 2, {1, 200, 3, 255}),
              testing::HasSubstr("1.0   1 200 3 1 9\n"));
}

TEST(PlyRewriter, ColoursOfOtherNamesChangeToo) {
  std::string other = kPlyText;
  for (const char* channel : {"red", "green", "blue"})
    other =
        replaced(other, std::string("uchar ") + channel, std::string("uchar diffuse_") + channel);
  EXPECT_EQ(recoloured(MeshFormat::kPly, other, 1, {1, 200, 3, 255}),
            replaced(other, "1.0   1 2 3 0\n0.2", "1.0   1 200 3 0\n0.2"));
}

TEST(PlyRewriter, LineEndsOfOldMacsStay) {
  const std::string before = with_cr(kSeamPly);
  EXPECT_EQ(rewritten(MeshFormat::kPly, before), before);
  const auto fold = [](size_t v, const Vec3d& p) { return v == 5 ? Vec3d(-1, 0, -1) : p; };
  EXPECT_EQ(rewritten(MeshFormat::kPly, before, fold),
            with_cr(rewritten(MeshFormat::kPly, kSeamPly, fold)));
}

/// A binary file with an element before the vertices, x y z of one type and a list behind them.
template <typename Number>
std::string binary_ply(const std::string& type, bool is_big_endian) {
  const auto bytes = [&](auto value) {
    std::string text = bytes_of(value);
    if (is_big_endian) std::reverse(text.begin(), text.end());
    return text;
  };
  std::string file = "ply\nformat binary_" + std::string(is_big_endian ? "big" : "little") +
                     "_endian 1.0\nelement user 2\nproperty list int short a\n"
                     "element vertex 3\nproperty uchar label\nproperty " +
                     type + " x\nproperty " + type + " y\nproperty " + type +
                     " z\nproperty list uchar uchar more\n"
                     "element face 1\nproperty list uchar uint vertex_index\nend_header\n";
  file += bytes(int32_t{1}) + bytes(int16_t{-5}) + bytes(int32_t{0});
  for (const auto& [x, y] : {std::pair(0, 0), std::pair(100, 0), std::pair(0, 100)}) {
    file += bytes(uint8_t{9}) + bytes(static_cast<Number>(x)) + bytes(static_cast<Number>(y));
    file += bytes(static_cast<Number>(7)) + bytes(uint8_t{1}) + bytes(uint8_t{77});
  }
  file += bytes(uint8_t{3}) + bytes(uint32_t{0}) + bytes(uint32_t{1}) + bytes(uint32_t{2});
  return file + "beyond the end";
}

template <typename Number>
void expect_round_trip(const std::string& type, double moved_to, Number written) {
  for (const bool is_big_endian : {false, true}) {
    const std::string file = binary_ply<Number>(type, is_big_endian);
    EXPECT_EQ(rewritten(MeshFormat::kPly, file), file) << type;
    const auto move = [&](size_t v, const Vec3d& p) {
      return v == 1 ? Vec3d(moved_to, p[1], p[2]) : p;
    };
    std::string before = bytes_of(static_cast<Number>(100)), after = bytes_of(written);
    if (is_big_endian) {
      std::reverse(before.begin(), before.end());
      std::reverse(after.begin(), after.end());
    }
    std::string expected = file;
    expected.replace(file.find("end_header\n") + 11 + 10 + 1 + 3 * sizeof(Number) + 2 + 1,
                     sizeof(Number), after);
    EXPECT_EQ(rewritten(MeshFormat::kPly, file, move), expected) << type << is_big_endian;
  }
}

TEST(PlyRewriter, BinaryCoordinatesKeepTheirTypeAndByteOrder) {
  expect_round_trip<float>("float", 0.1, 0.1F);
  expect_round_trip<double>("double", 512345.678, 512345.678);
  expect_round_trip<int32_t>("int", -70000.6, -70001);
  expect_round_trip<uint8_t>("uchar", 300, 255);
  expect_round_trip<int16_t>("int16", -40000, -32768);
}

TEST(PlyRewriter, AMoveBelowTheTypesPrecisionKeepsTheBytes) {
  const std::string file = binary_ply<float>("float", false);
  const auto move = [](size_t, const Vec3d& p) -> Vec3d { return p + Vec3d(0, 0, 1e-9); };
  EXPECT_EQ(rewritten(MeshFormat::kPly, file, move), file);
}

TEST(PlyRewriter, LongDecimalsStayDoubles) {
  std::string text = replaced(kPlyText, "0.1 1.0  0.0", "0.1 512345.678  0.0");
  const auto move = [](size_t v, const Vec3d& p) { return v == 1 ? Vec3d(512345.679, 0, 0) : p; };
  EXPECT_THAT(rewritten(MeshFormat::kPly, text, move), testing::HasSubstr("0.1 512345.679  "));
}

}  // namespace
}  // namespace burnish
