#include "common/mesh/rewrite/written_mesh.h"

#include <cmath>
#include <cstdio>

#include "tests/common/mesh/rewrite/rewriting.h"
#include "tests/common/temporary_folder.h"

namespace burnish {
namespace {

constexpr int kSide = 20;

/// Returns the vertices of a waved sheet around a corner, by a printf format of three doubles.
std::string sheet_positions(const char* begin, const char* format, const Vec3d& corner) {
  std::string text;
  for (int i = 0; i < kSide * kSide; ++i) {
    char line[200];
    std::snprintf(line, sizeof line, format, corner[0] + 3.137 * (i % kSide),
                  corner[1] + 3.137 * (i / kSide), corner[2] + std::sin(0.7 * i));
    text += begin + std::string(line) + "\n";
  }
  return text;
}

std::string sheet_faces(const char* begin, int first) {
  std::string text;
  for (int i = 0; i + kSide + 1 < kSide * kSide; ++i)
    text += begin + std::to_string(first + i) + " " + std::to_string(first + i + 1) + " " +
            std::to_string(first + i + kSide) + "\n";
  return text;
}

std::string obj_sheet(const char* format, const Vec3d& corner) {
  return sheet_positions("v ", format, corner) + sheet_faces("f ", 1);
}

const Vec3d kSurvey(499907.356, 4649907.242, 329.731);

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines(1);
  for (const char c : text)
    if (c == '\n')
      lines.emplace_back();
    else
      lines.back() += c;
  return lines;
}

TEST(WrittenMesh, ASurveyChangesTheLinesWhoseLastDigitMoves) {
  const std::string before = obj_sheet("%.3f %.3f %.3f", kSurvey);
  const auto fade = [](size_t v, const Vec3d& p) {
    return Vec3d(p[0], p[1], p[2] + 0.0203 / (1 + static_cast<double>(v)));
  };
  const std::string after = rewritten(MeshFormat::kObj, before, fade);
  const auto old_lines = lines_of(before), new_lines = lines_of(after);
  ASSERT_EQ(new_lines.size(), old_lines.size());
  for (size_t v = 0; v < old_lines.size(); ++v) {
    const bool moves = v < kSide * kSide && 0.0203 / (1 + static_cast<double>(v)) > 0.0005;
    EXPECT_EQ(new_lines[v] != old_lines[v], moves) << v;
    EXPECT_EQ(new_lines[v].size(), old_lines[v].size()) << new_lines[v];
  }
  EXPECT_LE(largest_move(MeshFormat::kObj, before, after), 0.0208);
}

TEST(WrittenMesh, EveryTextFormatKeepsItsDecimals) {
  const std::string positions = sheet_positions("", "%.3f %.3f %.3f", kSurvey);
  const std::string counts = std::to_string(kSide * kSide);
  const std::string faces = sheet_faces("3 ", 0);
  const std::string face_count = std::to_string(std::count(faces.begin(), faces.end(), '\n'));
  const std::string ply = "ply\nformat ascii 1.0\nelement vertex " + counts +
                          "\nproperty double x\nproperty double y\nproperty double z\n"
                          "element face " +
                          face_count + "\nproperty list uchar int vertex_indices\nend_header\n" +
                          positions + faces;
  const std::string off = "OFF\n" + counts + " " + face_count + " 0\n" + positions + faces;
  const std::string stl =
      "solid s\nfacet normal 0 0 1\nouter loop\nvertex 499907.356 4649907.242 329.731\n"
      "vertex 499910.500 4649907.242 329.000\nvertex 499907.356 4649910.500 329.000\nendloop\n"
      "endfacet\nendsolid s\n";
  const auto move = [](size_t, const Vec3d& p) -> Vec3d { return p + Vec3d(0.1, 0.0004, -0.25); };
  for (const auto& [format, text] :
       {std::pair(MeshFormat::kPly, ply), std::pair(MeshFormat::kOff, off),
        std::pair(MeshFormat::kStl, stl)}) {
    const std::string after = rewritten(format, text, move);
    EXPECT_EQ(after.size(), text.size());
    EXPECT_NE(after, text);
    const TriangleMesh old_mesh = parsed(format, text), new_mesh = parsed(format, after);
    for (size_t v = 0; v < old_mesh.vertices.size(); ++v)
      EXPECT_LT((new_mesh.vertices[v] - old_mesh.vertices[v] - Vec3d(0.1, 0, -0.25)).norm(), 1e-8);
  }
}

TEST(WrittenMesh, FloatsInATextHaveAllTheirDigits) {
  const std::string text = "v 0.1 0 0\nv 1.0 0 0\nv 0 1 0\nf 1 2 3\n";
  const auto move = [](size_t v, const Vec3d& p) { return v == 1 ? Vec3d(1.0625001, 0, 0) : p; };
  EXPECT_EQ(rewritten(MeshFormat::kObj, text, move), replaced(text, "1.0 0 0", "1.0625001 0 0"));
}

/// Moves every vertex by the cap, in many directions.
Vec3d move_by(double cap, size_t v, const Vec3d& position) {
  const auto angle = static_cast<double>(v);
  return position + (1 - 1e-6) * cap *
                        Vec3d(std::cos(angle) * std::cos(3 * angle),
                              std::sin(angle) * std::cos(3 * angle), std::sin(3 * angle));
}

void expect_capped(MeshFormat format, const std::string& text, double cap) {
  const auto move = [&](size_t v, const Vec3d& p) { return move_by(cap, v, p); };
  const double moved = largest_move(format, text, rewritten(format, text, move, cap));
  EXPECT_LE(moved, cap);
  EXPECT_GT(largest_move(format, text, rewritten(format, text, move)), cap) << "nothing rounds";
}

TEST(WrittenMesh, TheCapHoldsInTheDigitsOfTheFile) {
  expect_capped(MeshFormat::kObj, obj_sheet("%.9g %.9g %.9g", Vec3d(60, -40, 80)), 0.001);
  expect_capped(MeshFormat::kObj, obj_sheet("%.9g %.9g %.9g", kSurvey), 0.8);
  expect_capped(MeshFormat::kObj, obj_sheet("%.3f %.3f %.3f", kSurvey), 0.01);
  expect_capped(MeshFormat::kObj, obj_sheet("%.8e %.8e %.8e", kSurvey), 0.05);
}

TEST(WrittenMesh, TheCapHoldsInTheTypeOfABinary) {
  const TriangleMesh sheet = parsed(MeshFormat::kObj, obj_sheet("%.9g %.9g %.9g", kSurvey));
  for (const std::string type : {"float", "int"}) {
    std::string file = "ply\nformat binary_little_endian 1.0\nelement vertex " +
                       std::to_string(kSide * kSide) + "\n";
    for (const char* axis : {"x", "y", "z"}) file += "property " + type + " " + axis + "\n";
    file += "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
    for (const Vec3d& p : sheet.vertices)
      for (const double x : p)
        file += type == "int" ? bytes_of(static_cast<int32_t>(x)) : bytes_of(static_cast<float>(x));
    file += bytes_of(uint8_t{3}, 0, 1, kSide);
    expect_capped(MeshFormat::kPly, file, type == "int" ? 1.2 : 0.8);
  }
}

TEST(WrittenMesh, TheCapHoldsInAnotherFormat) {
  const TemporaryFolder folder;
  const std::string text = obj_sheet("%.9g %.9g %.9g", Vec3d(60, -40, 80));
  const auto original = folder.write("in.obj", text);
  const TriangleMesh before = parsed(MeshFormat::kObj, text);
  constexpr double kCap = 0.001;
  TriangleMesh after = before;
  for (size_t v = 0; v < after.vertices.size(); ++v)
    after.vertices[v] = move_by(kCap, v, after.vertices[v]);
  ASSERT_TRUE(write_moved_mesh({original, MeshFormat::kObj, "in"}, {before.vertices, after, kCap},
                               folder / "out.ply")
                  .is_ok());
  const auto written = read_mesh(folder / "out.ply");
  ASSERT_TRUE(written.is_ok());
  for (size_t v = 0; v < before.vertices.size(); ++v)
    EXPECT_LE((written->vertices[v] - before.vertices[v]).norm(), kCap);
}

}  // namespace
}  // namespace burnish
