#include <algorithm>
#include <limits>

#include "tests/common/mesh/reading.h"

namespace burnish {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr MeshFormat kPly = MeshFormat::kPly;
constexpr const char* kXyz = "property float x\nproperty float y\nproperty float z\n";
constexpr const char* kFaceList = "property list uchar int vertex_indices\n";

/// Returns a header for `vertices` and `faces` with plain properties.
std::string header(const std::string& format, int64_t vertices, int64_t faces) {
  return "ply\nformat " + format + " 1.0\nelement vertex " + std::to_string(vertices) + "\n" +
         kXyz + "element face " + std::to_string(faces) + "\n" + kFaceList + "end_header\n";
}

const std::string kPlySquare = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";

std::string square_with_faces(const std::string& faces) {
  return header("ascii", 4, std::count(faces.begin(), faces.end(), '\n')) + kPlySquare + faces;
}

/// Returns an ascii mesh of one triangle whose x has the declared type and this text.
std::string with_x(const std::string& type, const std::string& x) {
  return "ply\nformat ascii 1.0\nelement vertex 3\nproperty " + type +
         " x\nproperty float y\nproperty float z\nelement face 1\n" + kFaceList + "end_header\n" +
         x + " 0 0\n1 0 0\n1 1 0\n3 0 1 2\n";
}

std::string triangle_body() {
  return bytes_of(0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 1.F, 1.F, 0.F, uint8_t{3}, 0, 1, 2);
}

std::string big_endian(std::string bytes) {
  std::reverse(bytes.begin(), bytes.end());
  return bytes;
}

TEST(PlyReader, ReadsTextWithAnyLineEnds) {
  const std::string content = square_with_faces("3 0 1 2\n3 0 2 3\n");
  for (const std::string& text :
       {content, with_crlf(content), content + "\n \n", content.substr(0, content.size() - 1)}) {
    const TriangleMesh mesh = parsed(kPly, text);
    ASSERT_EQ(mesh.vertices.size(), 4u);
    EXPECT_EQ(mesh.vertices[2], Vec3d(1, 1, 0));
    EXPECT_THAT(mesh.triangles, ElementsAre(Triangle{0, 1, 2}, Triangle{0, 2, 3}));
    EXPECT_FALSE(mesh.has_colours());
    EXPECT_FALSE(mesh.has_double_positions);
  }
}

TEST(PlyReader, ReadsLittleEndian) {
  const TriangleMesh mesh =
      parsed(kPly, header("binary_little_endian", 3, 1) + triangle_body() + "trailing noise");
  ASSERT_EQ(mesh.vertices.size(), 3u);
  EXPECT_EQ(mesh.vertices[1], Vec3d(1, 0, 0));
  EXPECT_THAT(mesh.triangles, ElementsAre(Triangle{0, 1, 2}));
}

TEST(PlyReader, ReadsBigEndian) {
  std::string body;
  for (const float x : {0.F, 0.F, 0.F, 1.5F, 0.F, 0.F, 1.F, 1.F, 0.F})
    body += big_endian(bytes_of(x));
  body += '\3';
  for (const int index : {2, 0, 1}) body += big_endian(bytes_of(index));
  const TriangleMesh mesh = parsed(kPly, header("binary_big_endian", 3, 1) + body);
  ASSERT_EQ(mesh.vertices.size(), 3u);
  EXPECT_EQ(mesh.vertices[1], Vec3d(1.5, 0, 0));
  EXPECT_THAT(mesh.triangles, ElementsAre(Triangle{2, 0, 1}));
}

TEST(PlyReader, SkipsWhatItDoesNotKnowInAnyOrder) {
  std::string content =
      "ply\nformat binary_little_endian 1.0\ncomment end_header follows\nobj_info x\n"
      "element camera 1\nproperty list uchar float view\nproperty short id\n"
      "element face 1\nproperty uchar flag\nproperty list ushort uint16 vertex_index\n"
      "property double area\n"
      "element vertex 3\nproperty int8 quality\nproperty float z\nproperty list int8 int16 bag\n"
      "property float32 x\nproperty float y\nend_header\n";
  content += bytes_of(uint8_t{2}, 1.F, 2.F, int16_t{9});
  content += bytes_of(uint8_t{7}, uint16_t{3}, uint16_t{0}, uint16_t{1}, uint16_t{2}, 0.5);
  content += bytes_of(int8_t{1}, 3.F, int8_t{2}, int16_t{5}, int16_t{6}, 1.F, 2.F);
  content += bytes_of(int8_t{1}, 6.F, int8_t{0}, 4.F, 5.F);
  content += bytes_of(int8_t{1}, 9.F, int8_t{1}, int16_t{5}, 7.F, 9.F);
  const TriangleMesh mesh = parsed(kPly, content);
  EXPECT_THAT(mesh.vertices, ElementsAre(Vec3d(1, 2, 3), Vec3d(4, 5, 6), Vec3d(7, 9, 9)));
  EXPECT_THAT(mesh.triangles, ElementsAre(Triangle{0, 1, 2}));
}

TEST(PlyReader, PolygonsBecomeFansAndRepeatedVerticesStay) {
  const TriangleMesh mesh = parsed(kPly, square_with_faces("4 0 1 2 3\n3 1 1 2\n"));
  EXPECT_THAT(mesh.triangles, ElementsAre(Triangle{0, 1, 2}, Triangle{0, 2, 3}, Triangle{1, 1, 2}));
}

TEST(PlyReader, PolygonsThatUnfoldToFarMoreThanTheFileAreRefused) {
  constexpr int kFaces = 1000;
  std::string file = "ply\nformat binary_little_endian 1.0\nelement vertex 3\n" +
                     std::string(kXyz) + "element face " + std::to_string(kFaces) +
                     "\nproperty list uchar uchar vertex_indices\nend_header\n" +
                     bytes_of(0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 1.F, 1.F, 0.F);
  for (int face = 0; face < kFaces; ++face) {
    file += bytes_of(uint8_t{255});
    for (int corner = 0; corner < 255; ++corner) file += static_cast<char>(corner % 3);
  }
  EXPECT_THAT(refusal(kPly, file), HasSubstr("triangles, which take more than 4 times the"));
}

TEST(PlyReader, StripsAlternateRestartAtMinusOneAndDropTheirJoints) {
  const std::string start = "ply\nformat ascii 1.0\nelement vertex 4\n" + std::string(kXyz) +
                            "element tristrips 1\nproperty list int int vertex_indices\n"
                            "end_header\n" +
                            kPlySquare;
  EXPECT_THAT(parsed(kPly, start + "4 0 1 3 2\n").triangles,
              ElementsAre(Triangle{0, 1, 3}, Triangle{3, 1, 2}));
  EXPECT_THAT(parsed(kPly, start + "8 0 1 3 -1 1\n2 3 -1\n").triangles,
              ElementsAre(Triangle{0, 1, 3}, Triangle{1, 2, 3}));
  EXPECT_THAT(parsed(kPly, start + "5 0 1 1 3 2\n").triangles, ElementsAre(Triangle{1, 3, 2}));
}

TEST(PlyReader, BinaryStripsRestartAtTheLargestUnsignedIndexToo) {
  std::string content = "ply\nformat binary_little_endian 1.0\nelement vertex 3\n" +
                        std::string(kXyz) +
                        "element tristrips 1\nproperty list int uint vertex_indices\nend_header\n";
  content += triangle_body().substr(0, 36);
  content += bytes_of(5, 0U, 1U, 0xFFFFFFFFU, 0U, 1U);
  EXPECT_THAT(refusal(kPly, content), HasSubstr("no triangles"));
  content.replace(content.size() - 24, 24, bytes_of(5, 2U, 0xFFFFFFFFU, 0U, 1U, 2U));
  EXPECT_THAT(parsed(kPly, content).triangles, ElementsAre(Triangle{0, 1, 2}));
}

std::string with_colours(const std::string& type, const std::string& extra,
                         const std::string& colour) {
  std::string content = "ply\nformat ascii 1.0\nelement vertex 3\n" + std::string(kXyz);
  for (const char* channel : {"red", "green", "blue"})
    content += "property " + type + " " + channel + "\n";
  content += extra + "element face 1\n" + kFaceList + "end_header\n";
  for (const char* position : {"0 0 0 ", "1 0 0 ", "0 1 0 "}) content += position + colour + "\n";
  return content + "3 0 1 2\n";
}

TEST(PlyReader, KeepsColoursOfEveryType) {
  const auto first = [](const std::string& content) {
    const TriangleMesh mesh = parsed(kPly, content);
    return mesh.colours.size() == 3 ? mesh.colours[0] : Rgba8{};
  };
  EXPECT_EQ(first(with_colours("uchar", "", "1 2 255")), (Rgba8{1, 2, 255, 255}));
  EXPECT_EQ(first(with_colours("uchar", "property uchar alpha\n", "1 2 3 4")), (Rgba8{1, 2, 3, 4}));
  EXPECT_EQ(first(with_colours("float", "", "0 0.5 1.0")), (Rgba8{0, 128, 255, 255}));
  EXPECT_EQ(first(with_colours("ushort", "", "0 257 65535")), (Rgba8{0, 1, 255, 255}));
  EXPECT_EQ(first(with_colours("int", "", "-5 7 300")), (Rgba8{0, 7, 255, 255}));
  EXPECT_EQ(first(with_colours("float", "", "nan inf -inf")), (Rgba8{0, 255, 0, 255}));
  EXPECT_EQ(first(with_colours("float", "", "nan 1.0001 0.2")), (Rgba8{0, 255, 51, 255}));
  EXPECT_EQ(first(with_colours("float", "", "0.0 254.6 inf")), (Rgba8{0, 255, 255, 255}));
  EXPECT_EQ(first(with_colours("double", "property float alpha\n", "0.0 2 1 200")),
            (Rgba8{0, 2, 1, 200}));
}

TEST(PlyReader, OneVertexTellsTheRangeOfFloatColours) {
  std::string content = with_colours("float", "", "1 0 0.5");
  content.replace(content.find("0 1 0 1 0 0.5"), 13, "0 1 0 90 0 0.5");
  EXPECT_THAT(parsed(kPly, content).colours,
              ElementsAre(Rgba8{1, 0, 1, 255}, Rgba8{1, 0, 1, 255}, Rgba8{90, 0, 1, 255}));
}

TEST(PlyReader, KnowsOtherNamesOfColours) {
  const auto renamed = [](const std::array<const char*, 3>& names) {
    std::string content = with_colours("uchar", "", "1 2 3");
    const std::array<const char*, 3> usual = {"red", "green", "blue"};
    for (size_t i = 0; i < 3; ++i) {
      const std::string old = std::string("uchar ") + usual[i];
      content.replace(content.find(old), old.size(), std::string("uchar ") + names[i]);
    }
    return content;
  };
  for (const auto& names :
       {std::array{"diffuse_red", "diffuse_green", "diffuse_blue"}, std::array{"r", "g", "b"}}) {
    const TriangleMesh mesh = parsed(kPly, renamed(names));
    ASSERT_TRUE(mesh.has_colours()) << names[0];
    EXPECT_EQ(mesh.colours[2], (Rgba8{1, 2, 3, 255}));
  }
  EXPECT_FALSE(parsed(kPly, renamed({"diffuse_red", "green", "b"})).has_colours());
  const std::string both =
      with_colours("uchar",
                   "property uchar diffuse_red\nproperty uchar diffuse_green\nproperty uchar "
                   "diffuse_blue\n",
                   "1 2 3 7 8 9");
  EXPECT_EQ(parsed(kPly, both).colours[0], (Rgba8{1, 2, 3, 255}));
}

TEST(PlyReader, AnIncompleteColourIsNone) {
  std::string content = with_colours("uchar", "", "1 2 3");
  content.replace(content.find("green"), 5, "olive");
  EXPECT_FALSE(parsed(kPly, content).has_colours());
}

TEST(PlyReader, KnowsWhenPositionsSayMoreThanFloats) {
  EXPECT_TRUE(parsed(kPly, with_x("double", "0")).has_double_positions);
  EXPECT_TRUE(parsed(kPly, with_x("int", "0")).has_double_positions);
  EXPECT_FALSE(parsed(kPly, with_x("short", "0")).has_double_positions);
  EXPECT_TRUE(parsed(kPly, with_x("float", "512345.678")).has_double_positions);
  EXPECT_FALSE(parsed(kPly, with_x("float", "0.100000001490116119384765625")).has_double_positions);
  EXPECT_FALSE(parsed(kPly, with_x("float", "0.3333333")).has_double_positions);
}

TEST(PlyReader, RefusesWhatIsNoPlyFile) {
  EXPECT_THAT(refusal(kPly, ""), HasSubstr("scan: the file is empty (0 bytes)"));
  EXPECT_THAT(refusal(kPly, "plywood\n"),
              HasSubstr("line 1: not a PLY file: begins with 'plywood', not 'ply'"));
  EXPECT_THAT(refusal(kPly, " \n\n"), HasSubstr("not a PLY file: begins with ''"));
  EXPECT_THAT(refusal(kPly, std::string(3000, '\x80')),
              HasSubstr("begins with '" + std::string(40, '?') + "...'"));
}

TEST(PlyReader, RefusesAnUnknownFormatOrVersion) {
  EXPECT_THAT(refusal(kPly, "ply\nformat binary 1.0\nend_header\n"),
              HasSubstr("line 2: unknown format 'binary'"));
  EXPECT_THAT(refusal(kPly, "ply\nformat ascii 2.0\nend_header\n"),
              HasSubstr("line 2: PLY version '2.0' is not supported; use 1.0"));
  EXPECT_THAT(refusal(kPly, "ply\nend_header\n"), HasSubstr("no 'format' line"));
}

TEST(PlyReader, RefusesAHeaderWithoutEnd) {
  EXPECT_THAT(refusal(kPly, "ply\nformat ascii 1.0\nelement vertex 3\n"),
              HasSubstr("line 3: the header has no 'end_header'"));
  EXPECT_THAT(refusal(kPly, "ply\nformat ascii 1.0\n0 0 0\n"),
              HasSubstr("line 3: unknown header keyword '0'; is 'end_header' missing?"));
}

TEST(PlyReader, RefusesAnOverlongHeaderLine) {
  EXPECT_THAT(refusal(kPly, "ply\ncomment " + std::string(1 << 20, 'x') + "\nend_header\n"),
              HasSubstr("line 2: the header line has 1048584 bytes, the limit is 1048576"));
}

TEST(PlyReader, RefusesBadDeclarations) {
  const auto refused = [](const std::string& lines) {
    return refusal(kPly, "ply\nformat ascii 1.0\n" + lines + "end_header\n");
  };
  EXPECT_THAT(refused("property float x\n"), HasSubstr("line 3: a property comes before any"));
  EXPECT_THAT(refused("element vertex many\n"), HasSubstr("'vertex' has the count 'many'"));
  EXPECT_THAT(refused("element vertex -3\n"), HasSubstr("'vertex' has the count '-3'"));
  EXPECT_THAT(refused("element vertex 99999999999999999999\n"), HasSubstr("has the count '9999"));
  EXPECT_THAT(refused("element vertex 3000000000\n"),
              HasSubstr("has the count 3000000000, the limit is 2147483648"));
  EXPECT_THAT(refused("element face 3000000000\n"), HasSubstr("the limit is 2147483648"));
  EXPECT_THAT(refused("element a 0\nelement a 0\n"), HasSubstr("line 4: element 'a' is declared"));
  EXPECT_THAT(refused("element a 0\nproperty half x\n"),
              HasSubstr("line 4: unknown property type 'half'"));
  EXPECT_THAT(refused("element a 0\nproperty list float int x\n"), HasSubstr("must be an integer"));
  EXPECT_THAT(refused("element a 0\nproperty float\n"), HasSubstr("a property has no name"));
  EXPECT_THAT(refused("element a 0\nproperty float x\nproperty int x\n"),
              HasSubstr("line 5: property 'x' of element 'a' is declared twice"));
}

TEST(PlyReader, RefusesThousandsOfDeclarations) {
  std::string content = "ply\nformat ascii 1.0\nelement vertex 0\n";
  for (int i = 0; i < 1100; ++i) content += "property float p" + std::to_string(i) + "\n";
  EXPECT_THAT(refusal(kPly, content), HasSubstr("more than 1024 elements and properties"));
}

TEST(PlyReader, RefusesHeadersWithoutPositionsOrFaces) {
  const std::string start = "ply\nformat ascii 1.0\n";
  EXPECT_THAT(refusal(kPly, start + "element face 0\nend_header\n"),
              HasSubstr("no element 'vertex'"));
  EXPECT_THAT(refusal(kPly, start + "element vertex 0\nproperty float x\nproperty float y\n"
                                    "end_header\n"),
              HasSubstr("element 'vertex' has no numeric property 'z'"));
  EXPECT_THAT(refusal(kPly, start + "element vertex 0\nproperty list uchar float x\nend_header\n"),
              HasSubstr("no numeric property 'x'"));
  EXPECT_THAT(refusal(kPly, header("ascii", 4, 0) + kPlySquare),
              HasSubstr("no faces, only points"));
  EXPECT_THAT(refusal(kPly, start + "element vertex 0\n" + kXyz +
                                "element face 1\nproperty int vertex_indices\nend_header\n0 0\n"),
              HasSubstr("element 'face' has no integer list 'vertex_indices'"));
}

TEST(PlyReader, AbsurdCountsAreRefusedBeforeMemoryIsTaken) {
  EXPECT_THAT(refusal(kPly, header("binary_little_endian", 2'000'000'000, 1) + triangle_body()),
              AllOf(HasSubstr("promises 2000000000 of element 'vertex', at least 12 bytes each"),
                    HasSubstr("49 of the file's"), HasSubstr("vertex 4 is not complete")));
  EXPECT_THAT(refusal(kPly, header("ascii", 4, 2'000'000'000) + kPlySquare),
              HasSubstr("promises 2000000000 of element 'face', at least 2 bytes each"));
  EXPECT_THAT(refusal(kPly,
                      "ply\nformat binary_big_endian 1.0\nelement big 9223372036854775807\n"
                      "property double a\nend_header\n"),
              HasSubstr("promises 9223372036854775807 of element 'big'"));
}

TEST(PlyReader, TruncatedBinaryNamesTheElementAndTheByte) {
  const std::string content = header("binary_little_endian", 3, 1) + triangle_body();
  EXPECT_THAT(refusal(kPly, content.substr(0, content.size() - 1)),
              HasSubstr("face 0: list 'vertex_indices' has the count 3, but at most 2 values"));
  EXPECT_THAT(refusal(kPly, content.substr(0, content.size() - 20)),
              HasSubstr("vertex 2 is not complete"));
  for (size_t length = 0; length < content.size(); ++length)
    EXPECT_FALSE(parse(kPly, content.substr(0, length)).is_ok()) << length << " bytes";
}

TEST(PlyReader, TruncatedBinaryIsRefusedInPropertiesThatAreSkippedToo) {
  const std::string start = "ply\nformat binary_little_endian 1.0\nelement vertex 3\n" +
                            std::string(kXyz) +
                            "element face 1\nproperty list uchar uchar vertex_indices\n"
                            "property double area\nproperty list uchar int tags\nend_header\n" +
                            triangle_body().substr(0, 36);
  const std::string face = bytes_of(uint8_t{3}, uint8_t{0}, uint8_t{1}, uint8_t{2}, 0.5) + "\2";
  EXPECT_THAT(refusal(kPly, start + face.substr(0, 11)),
              HasSubstr("face 0: the file ends inside it"));
  EXPECT_THAT(refusal(kPly, start + face + "1234567"), HasSubstr("list 'tags' has the count 2"));
  EXPECT_TRUE(parse(kPly, start + face + "12345678").is_ok());
}

TEST(PlyReader, TruncatedTextNamesTheElementAndTheLine) {
  const std::string content = square_with_faces("3 0 1 2\n3 0 2 3\n");
  EXPECT_THAT(refusal(kPly, content.substr(0, content.size() - 3)),
              HasSubstr("line 15: face 1: the file ends inside it"));
  for (size_t length = 0; length < content.size() - 2; ++length)
    EXPECT_FALSE(parse(kPly, content.substr(0, length)).is_ok()) << length << " bytes";
}

TEST(PlyReader, TextElementsEndWithTheirLines) {
  EXPECT_THAT(refusal(kPly, header("ascii", 4, 1) + "0 0 0\n1 0\n1 1 0\n0 1 0\n3 0 1 2\n"),
              HasSubstr("line 12: vertex 1: the line continues after its last value"));
  EXPECT_THAT(refusal(kPly, square_with_faces("3 0 1 2 3\n")),
              HasSubstr("line 14: face 0: the line continues"));
}

TEST(PlyReader, RefusesTextThatIsNoNumber) {
  EXPECT_THAT(refusal(kPly, with_x("float", "one")),
              HasSubstr("line 10: vertex 0: 'one' is not a value of the declared type"));
  EXPECT_THAT(refusal(kPly, with_x("int", "1.5")), HasSubstr("'1.5' is not a value"));
  EXPECT_THAT(refusal(kPly, square_with_faces("3 0 1 2.5\n")), HasSubstr("face 0: '2.5' is not"));
}

TEST(PlyReader, RefusesAbsurdListCounts) {
  EXPECT_THAT(refusal(kPly, square_with_faces("-3 0 1 2\n")),
              HasSubstr("line 14: face 0: list 'vertex_indices' has the count -3, but at most"));
  EXPECT_THAT(refusal(kPly, square_with_faces("4000000000 0 1 2\n")),
              HasSubstr("has the count 4000000000, but at most 4 values are left"));
  std::string binary = "ply\nformat binary_little_endian 1.0\nelement vertex 3\n" +
                       std::string(kXyz) +
                       "element face 1\nproperty list int int vertex_indices\nend_header\n" +
                       triangle_body().substr(0, 36);
  EXPECT_THAT(refusal(kPly, binary + bytes_of(-1, 0, 1, 2)), HasSubstr("has the count -1"));
  EXPECT_THAT(refusal(kPly, binary + bytes_of(0x7FFFFFFF, 0, 1, 2)),
              HasSubstr("has the count 2147483647, but at most 3 values are left"));
}

TEST(PlyReader, FacesOfFewerThanThreeCornersAreCarried) {
  EXPECT_THAT(parsed(kPly, square_with_faces("2 0 1\n3 0 1 2\n1 3\n0\n")).triangles,
              ElementsAre(Triangle{0, 1, 2}));
  EXPECT_THAT(refusal(kPly, square_with_faces("0\n")), HasSubstr("mesh has no triangles"));
}

TEST(PlyReader, ARangeGridIsNamed) {
  EXPECT_THAT(refusal(kPly, "ply\nformat ascii 1.0\nobj_info num_cols 1\nelement vertex 1\n" +
                                std::string(kXyz) +
                                "element range_grid 1\nproperty list uchar int vertex_indices\n"
                                "end_header\n0 0 0\n1 0\n"),
              HasSubstr("range_grid"));
}

TEST(PlyReader, LinesMayEndInCr) {
  const std::string text = square_with_faces("3 0 1 2\n3 0 2 3\n");
  EXPECT_EQ(parsed(kPly, with_cr(text)).vertices, parsed(kPly, text).vertices);
  EXPECT_EQ(parsed(kPly, with_cr(text)).triangles, parsed(kPly, text).triangles);
  const std::string head = header("binary_little_endian", 3, 1);
  std::string body = triangle_body();
  body.replace(0, 4, bytes_of(uint32_t{0x3F80000A}));  // the first byte is an LF
  for (const std::string& start : {head, with_cr(head), with_crlf(head)}) {
    const TriangleMesh mesh = parsed(kPly, start + body);
    EXPECT_EQ(mesh.vertices[0][0], static_cast<double>(std::bit_cast<float>(0x3F80000A)));
    EXPECT_THAT(mesh.triangles, ElementsAre(Triangle{0, 1, 2}));
  }
}

TEST(PlyReader, CarriesVerticesWithoutPlaceThatNoFaceUses) {
  std::string content = square_with_faces("3 0 1 2\n");
  const size_t last = content.rfind("\n", content.find("3 0 1 2") - 2) + 1;
  content.replace(last, content.find("3 0 1 2") - last, "nan -inf 5\n");
  const TriangleMesh mesh = parsed(kPly, content);
  EXPECT_EQ(mesh.vertices[3], Vec3d(mesh.vertices[0][0], mesh.vertices[0][1], 5));
}

TEST(PlyReader, RefusesIndicesOutOfRange) {
  EXPECT_THAT(refusal(kPly, square_with_faces("3 0 1 2\n3 0 1 4\n")),
              HasSubstr("line 15: face 1 refers to vertex 4, but there are 4, numbered from 0"));
  EXPECT_THAT(refusal(kPly, square_with_faces("3 0 -1 2\n")), HasSubstr("refers to vertex -1"));
  std::string binary = header("binary_little_endian", 3, 1) + triangle_body();
  binary.replace(binary.size() - 4, 4, bytes_of(1000));
  EXPECT_THAT(refusal(kPly, binary), HasSubstr("face 0 refers to vertex 1000, but there are 3"));
}

TEST(PlyReader, RefusesCoordinatesThatAreNotFiniteOrTooLarge) {
  EXPECT_THAT(refusal(kPly, with_x("float", "nan")),
              HasSubstr("line 10: vertex 0: x = nan; coordinates must be finite and within"));
  EXPECT_THAT(refusal(kPly, with_x("double", "-inf")), HasSubstr("vertex 0: x = -inf"));
  EXPECT_THAT(refusal(kPly, with_x("float", "2e18")), HasSubstr("vertex 0: x = 2e+18"));
  std::string binary = header("binary_little_endian", 3, 1) + triangle_body();
  const size_t y = binary.size() - 49 + 16;
  binary.replace(y, 4, bytes_of(std::numeric_limits<float>::quiet_NaN()));
  EXPECT_THAT(refusal(kPly, binary),
              HasSubstr("byte " + std::to_string(y + 4) + ": vertex 1: y = nan"));
}

}  // namespace
}  // namespace burnish
