#include "common/mesh/rewrite/patch/written_mesh.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "common/mesh/io/mesh_io.h"
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

/// The place of a sheet, near 0 and as surveys have it.
const std::vector<Vec3d> kCorners = {Vec3d(12.345, 0.25, 3.141), kSurvey};

// A ten-millionth of the sheet's diagonal, 84, has six decimals.
constexpr double kSheetStep = 1e-6;

std::string text_sheet(MeshFormat format, const std::string& type, const Vec3d& corner) {
  const std::string positions = sheet_positions("", "%.3f %.3f %.3f", corner);
  const std::string counts = std::to_string(kSide * kSide);
  const std::string faces = sheet_faces("3 ", 0);
  const std::string face_count = std::to_string(std::count(faces.begin(), faces.end(), '\n'));
  if (format == MeshFormat::kObj) return obj_sheet("%.3f %.3f %.3f", corner);
  if (format == MeshFormat::kOff)
    return "OFF\n" + counts + " " + face_count + " 0\n" + positions + faces;
  if (format == MeshFormat::kPly)
    return "ply\nformat ascii 1.0\nelement vertex " + counts + "\nproperty " + type +
           " x\nproperty " + type + " y\nproperty " + type + " z\nelement face " + face_count +
           "\nproperty list uchar int vertex_indices\nend_header\n" + positions + faces;
  const std::vector<std::string> lines = lines_of(positions);
  std::string stl = "solid s\n";
  for (size_t v = 0; v + kSide + 1 < kSide * kSide; ++v) {
    stl += "facet normal 0.000 0.000 1.000\nouter loop\n";
    for (const size_t corner_of : {v, v + 1, v + kSide}) stl += "vertex " + lines[corner_of] + "\n";
    stl += "endloop\nendfacet\n";
  }
  return stl + "endsolid s\n";
}

struct TextKind {
  MeshFormat format;
  const char* type;
};

const std::vector<TextKind> kTextKinds = {{MeshFormat::kObj, ""},
                                          {MeshFormat::kOff, ""},
                                          {MeshFormat::kStl, ""},
                                          {MeshFormat::kPly, "float"},
                                          {MeshFormat::kPly, "double"}};

TEST(WrittenMesh, ATextChangesTheLinesThatMoveByMoreThanHalfOfTheLastDigit) {
  const auto amount = [](size_t v) { return 0.0203 * std::exp(-0.05 * static_cast<double>(v)); };
  const auto fade = [&](size_t v, const Vec3d& p) { return Vec3d(p[0], p[1], p[2] + amount(v)); };
  for (const Vec3d& corner : kCorners) {
    const std::string before = obj_sheet("%.3f %.3f %.3f", corner);
    const std::string after = rewritten(MeshFormat::kObj, before, fade);
    const auto old_lines = lines_of(before), new_lines = lines_of(after);
    ASSERT_EQ(new_lines.size(), old_lines.size());
    for (size_t v = 0; v < old_lines.size(); ++v) {
      const bool moves = v < kSide * kSide && amount(v) > kSheetStep / 2;
      EXPECT_EQ(new_lines[v] != old_lines[v], moves) << v;
      EXPECT_LE(new_lines[v].size(), old_lines[v].size() + 3) << new_lines[v];
    }
    EXPECT_LE(largest_move(MeshFormat::kObj, before, after), 0.0203 + kSheetStep);
  }
}

TEST(WrittenMesh, EveryTextFormatKeepsItsDecimalsWhereverTheScanLies) {
  const auto move = [](size_t, const Vec3d& p) -> Vec3d { return p + Vec3d(0.1, 0, -0.25); };
  for (const TextKind& kind : kTextKinds)
    for (const Vec3d& corner : kCorners) {
      const std::string text = text_sheet(kind.format, kind.type, corner);
      const std::string after = rewritten(kind.format, text, move);
      const bool has_longer_normals = kind.format == MeshFormat::kStl;
      EXPECT_EQ(after.size() > text.size(), has_longer_normals) << after.substr(0, 400);
      EXPECT_GE(after.size(), text.size());
      EXPECT_NE(after, text);
      const TriangleMesh old_mesh = parsed(kind.format, text),
                         new_mesh = parsed(kind.format, after);
      for (size_t v = 0; v < old_mesh.vertices.size(); ++v)
        ASSERT_LT((new_mesh.vertices[v] - old_mesh.vertices[v] - Vec3d(0.1, 0, -0.25)).norm(),
                  1e-8);
    }
}

TEST(WrittenMesh, RoundingToATextStaysBelowAFifthOfTheAccuracy) {
  constexpr double kDiagonal = 84;
  const auto move = [](size_t v, const Vec3d& p) -> Vec3d {
    return p + 0.01 * Vec3d(std::sin(v), std::cos(v), std::sin(3 * v));
  };
  for (const TextKind& kind : kTextKinds)
    for (const Vec3d& corner : kCorners) {
      const std::string text = text_sheet(kind.format, kind.type, corner);
      const std::string after = rewritten(kind.format, text, move);
      EXPECT_LT(after.size(), text.size() * 13 / 10);
      const TriangleMesh old_mesh = parsed(kind.format, text),
                         new_mesh = parsed(kind.format, after);
      for (size_t v = 0; v < old_mesh.vertices.size(); ++v)
        ASSERT_LT((new_mesh.vertices[v] - move(v, old_mesh.vertices[v])).norm(), 1e-7 * kDiagonal);
    }
}

TEST(WrittenMesh, ATextOfWholeNumbersIsWrittenAsExactlyAsOneOfDecimals) {
  const std::string text = "v 0 0 0\nv 100 0 0\nv 0 100 0\nf 1 2 3\n";
  const auto move = [](size_t v, const Vec3d& p) { return v == 1 ? Vec3d(100.123456, 0, 0) : p; };
  EXPECT_EQ(rewritten(MeshFormat::kObj, text, move),
            replaced(text, "v 100 0 0", "v 100.12346 0 0"));
}

TEST(WrittenMesh, AWrittenTextComesBackAsItIsWhenItIsWrittenAgain) {
  const auto move = [](size_t v, const Vec3d& p) -> Vec3d {
    return p + 0.01 * Vec3d(std::sin(v), std::cos(v), std::sin(3 * v));
  };
  for (const TextKind& kind : kTextKinds)
    for (const Vec3d& corner : kCorners) {
      const std::string once =
          rewritten(kind.format, text_sheet(kind.format, kind.type, corner), move);
      EXPECT_EQ(rewritten(kind.format, once), once);
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
  return position + (1 - 1e-7) * cap *
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
