// `burnish filter` and `generate` as users see them: files in, files out, exit codes.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "common/base/process_memory.h"
#include "common/generate/generate.h"
#include "common/mesh/io/mesh_io.h"
#include "tests/common/gltf/glb_file.h"
#include "tests/system/filter_command.h"

namespace burnish {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST_F(FilterCommand, SmoothsASphereAndReportsTheRun) {
  ASSERT_EQ(burnish({"filter", in(), out(), "--depth", "5", "--alpha", "3", "--beta", "0",
                     "--exact", "--backend", "cpu", "--report", path("report.json")}),
            0)
      << output_;
  const TriangleMesh before = read_mesh(in()).value(), after = read_mesh(out()).value();
  EXPECT_EQ(after.triangles, before.triangles);
  EXPECT_LT(after.vertices[0].norm(), 0.8 * before.vertices[0].norm());
  const nlohmann::json run = report();
  EXPECT_EQ(run["grid"]["depth"], 5);
  EXPECT_EQ(run["counts"]["vertices"], before.vertices.size());
  EXPECT_EQ(run["backend"], "cpu");
  EXPECT_TRUE(run["converged"]);
  EXPECT_LT(run["energy"], 0);
  EXPECT_LE(run["distance"], 3e-7);
  EXPECT_GT(run["memory"]["session_bytes"], 0);
}

TEST_F(FilterCommand, RimsStayUnlessTheyAreLetGo) {
  const TriangleMesh sheet = make_sheet(30, 1, 0.1);
  ASSERT_TRUE(write_mesh(sheet, in()).is_ok());
  const std::vector<std::string> smooth = {"filter",  in(), out(),    "--depth", "5",
                                           "--alpha", "10", "--beta", "0"};
  ASSERT_EQ(burnish(smooth), 0) << output_;
  EXPECT_THAT(output_, HasSubstr("--pin-rims off"));
  EXPECT_EQ(read_mesh(out()).value().vertices[0], sheet.vertices[0]);
  std::vector<std::string> free = smooth;
  free.insert(free.end(), {"--pin-rims", "off"});
  ASSERT_EQ(burnish(free), 0) << output_;
  EXPECT_GT((read_mesh(out()).value().vertices[0] - sheet.vertices[0]).norm(), 0.02);
  EXPECT_EQ(burnish({"filter", in(), out(), "--keep-volume", "on"}), 1);
  EXPECT_THAT(output_, HasSubstr("not closed"));
}

TEST_F(FilterCommand, WallsThinnerThanACellAreTold) {
  const std::vector<std::string> smooth = {"filter", in(),  out(),      "--depth",          "5",
                                           "--beta", "0.5", "--report", path("report.json")};
  ASSERT_EQ(burnish(smooth), 0) << output_;
  EXPECT_THAT(output_, testing::Not(HasSubstr("Walls"))) << "a sphere has none";
  EXPECT_TRUE(report()["walls"].is_null());
  ASSERT_TRUE(write_mesh(generate_scan({"sheets", 2000, 1}).value(), in()).is_ok());
  ASSERT_EQ(burnish(smooth), 0) << output_;
  EXPECT_THAT(output_, HasSubstr("Walls: 100 % of the surface is thinner than a cell; an edit"));
  EXPECT_GT(report()["walls"]["share"], 0.9);
  EXPECT_GT(report()["walls"]["depth"], 5);
}

TEST_F(FilterCommand, AKeptVolumeIsReportedAndALostOneToldWithItsFigure) {
  const std::vector<std::string> strong = {
      "filter", in(), out(),           "--depth", "5",       "--alpha",  "2",
      "--beta", "0",  "--keep-volume", "on",      "--exact", "--report", path("report.json")};
  ASSERT_EQ(burnish(strong), 0) << output_;
  EXPECT_NEAR(report()["volume"].get<double>(), 1, 1e-6);
  EXPECT_THAT(output_, testing::Not(HasSubstr("volume")));
  EXPECT_NEAR(read_mesh(out()).value().vertices[0].norm(), 10, 0.2);
  ASSERT_TRUE(write_mesh(generate_scan({"blob", 3000, 1}).value(), in()).is_ok());
  std::vector<std::string> capped = strong;
  capped.insert(capped.end(), {"--cap", "0.02"});
  ASSERT_EQ(burnish(capped), 0) << output_;
  EXPECT_NEAR(report()["volume"].get<double>(), 1, 1e-6);
  EXPECT_THAT(output_, testing::Not(HasSubstr("volume")));
  const Vec3d spot = read_mesh(in()).value().vertices[0];
  std::ofstream(path("stroke")) << "brush 0.1 1 0 smooth\n"
                                << spot.x() << " " << spot.y() << " " << spot.z() << "\n";
  ASSERT_EQ(burnish({"filter", in(), out(), "--depth", "5", "--alpha", "2", "--beta-paint",
                     path("stroke"), "--keep-volume", "on", "--cap", "0.02", "--exact", "--report",
                     path("report.json"), "--force"}),
            0)
      << output_;
  EXPECT_GT(std::abs(report()["volume"].get<double>() - 1), 1e-6);
  EXPECT_THAT(output_, HasSubstr("the largest move wins"));
}

TEST_F(FilterCommand, AVolumeOfNothingIsRefusedWithItsFigure) {
  TriangleMesh two = make_icosphere(3, 1);
  const TriangleMesh other = two;
  const auto first = static_cast<uint32_t>(two.vertices.size());
  for (const Vec3d& v : other.vertices) two.vertices.push_back(v + Vec3d(4, 0, 0));
  for (const Triangle& t : other.triangles)
    two.triangles.push_back({t[1] + first, t[0] + first, t[2] + first});
  ASSERT_TRUE(write_mesh(two, in()).is_ok());
  EXPECT_EQ(burnish({"filter", in(), out(), "--beta", "0", "--keep-volume", "on"}), 1);
  EXPECT_THAT(output_, HasSubstr("must be at least 0.00016"));
  EXPECT_FALSE(std::filesystem::exists(out()));
}

TEST_F(FilterCommand, APresetHasAStrengthAndAWaveALength) {
  const auto radius_after = [&](const std::vector<std::string>& options) {
    std::vector<std::string> arguments = {"filter", in(), out(), "--depth", "5"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    EXPECT_EQ(burnish(arguments), 0) << output_;
    return read_mesh(out()).value().vertices[0].norm();
  };
  const double all = radius_after({"--preset", "Smooth broadly"});
  EXPECT_DOUBLE_EQ(radius_after({"--preset", "Smooth broadly", "--strength", "0"}), 10);
  EXPECT_NEAR(radius_after({"--preset", "Smooth broadly", "--strength", "0.5"}), (10 + all) / 2,
              1e-3);
  const double length_unit = std::sqrt(4 * std::numbers::pi) * 10;
  EXPECT_NEAR(radius_after({"--beta", "0", "--wavelength", std::to_string(0.15 * length_unit)}),
              all, 0.01);
  EXPECT_EQ(burnish({"filter", in(), out(), "--preset", "Nothing"}), 1);
  EXPECT_THAT(output_, HasSubstr("Nothing"));
  EXPECT_EQ(burnish({"filter", in(), out(), "--strength", "0.5"}), 2);
}

TEST_F(FilterCommand, DepthsAreToldBeforeAnyIsPrepared) {
  ASSERT_EQ(burnish({"filter", in(), out(), "--depths"}), 0) << output_;
  EXPECT_THAT(output_, HasSubstr("shortest wave"));
  EXPECT_THAT(output_, HasSubstr("default"));
  EXPECT_FALSE(std::filesystem::exists(out()));
}

TEST_F(FilterCommand, FieldsOutReadBackAsCellFieldGiveTheSameSurface) {
  ASSERT_EQ(burnish({"filter", in(), out(), "--depth", "5", "--curve", "-5:10,3:40", "--beta",
                     "0.5", "--exact", "--fields-out", path("fields")}),
            0)
      << output_;
  ASSERT_EQ(burnish({"filter", in(), path("again.ply"), "--depth", "5", "--exact", "--cell-field",
                     path("fields")}),
            0)
      << output_;
  const auto once = read_mesh(out()).value(), again = read_mesh(path("again.ply")).value();
  for (size_t v = 0; v < once.vertices.size(); ++v)
    ASSERT_LT((once.vertices[v] - again.vertices[v]).norm(), 1e-5);
}

TEST_F(FilterCommand, FieldsBeginWithTheGrid) {
  ASSERT_EQ(burnish({"filter", in(), out(), "--depth", "4", "--cycles", "1", "--fields-out",
                     path("fields")}),
            0)
      << output_;
  std::ifstream file(path("fields"));
  std::string header;
  std::getline(file, header);
  EXPECT_THAT(header, testing::StartsWith("# origin "));
  EXPECT_THAT(header, HasSubstr(" depth 4"));
}

TEST_F(FilterCommand, PaintMovesOnlyTheSurfaceNearIt) {
  std::ofstream(path("stroke")) << "brush 3 1 0 smooth\n0 0 10\n";
  ASSERT_EQ(burnish({"filter", in(), out(), "--depth", "5", "--alpha", "20", "--exact",
                     "--beta-paint", path("stroke")}),
            0)
      << output_;
  const TriangleMesh before = read_mesh(in()).value(), after = read_mesh(out()).value();
  double top = 0, bottom = 0;
  for (size_t v = 0; v < before.vertices.size(); ++v) {
    const double moved = (after.vertices[v] - before.vertices[v]).norm();
    (before.vertices[v].z() > 0 ? top : bottom) =
        std::max(before.vertices[v].z() > 0 ? top : bottom, moved);
  }
  EXPECT_GT(top, 0.01);
  EXPECT_LT(bottom, top / 1000);
}

TEST_F(FilterCommand, WrongOptionValuesAreUsageErrors) {
  const auto usage = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"filter", in(), out()});
    return burnish(more);
  };
  EXPECT_EQ(usage({"--depth", "13"}), 2);
  EXPECT_THAT(output_, HasSubstr("13"));
  EXPECT_EQ(usage({"--alpha", "-1"}), 2);
  EXPECT_EQ(usage({"--beta", "11"}), 2);
  EXPECT_EQ(usage({"--curve", "5:1,5:2"}), 2);
  EXPECT_THAT(output_, HasSubstr("must be above the kappa before it"));
  EXPECT_EQ(usage({"--curve", "0:1,1:2000"}), 2);
  EXPECT_THAT(output_, HasSubstr("contrast"));
  EXPECT_EQ(usage({"--exact", "--cycles", "3"}), 2);
  EXPECT_EQ(usage({"--backend", "abacus"}), 2);
  EXPECT_FALSE(std::filesystem::exists(out()));
}

TEST_F(FilterCommand, ARangeIsToldInNumbersForPeople) {
  const std::vector<std::pair<std::vector<std::string>, const char*>> cases = {
      {{"--cap", "-1"}, "--cap: -1 is outside 0 to 1e+18"},
      {{"--beta", "77"}, "--beta: 77 is outside 0 to 10"},
      {{"--alpha", "-3"}, "--alpha: -3 is outside 0.01 to 100000"},
      {{"--wavelength", "0"}, "--wavelength: 0 is not a number above 0"},
      {{"--cycles", "0"}, "--cycles: 0 is outside 1 to "},
      {{"--depth", "99"}, "--depth: 99 is outside 4 to 12"},
      {{"--palette", ""}, "--palette: '' names nothing"}};
  for (const auto& [options, text] : cases) {
    std::vector<std::string> words = {"filter", in(), out()};
    words.insert(words.end(), options.begin(), options.end());
    EXPECT_EQ(burnish(words), 2);
    EXPECT_THAT(output_, HasSubstr(text));
    EXPECT_THAT(output_, Not(HasSubstr("000000")));
  }
}

TEST_F(FilterCommand, AnEmptyPaletteIsRefusedWithItsName) {
  for (const char* text : {"", "\n\n", "# curves to come\n"}) {
    folder_.write("curves.txt", text);
    EXPECT_EQ(burnish({"filter", in(), out(), "--palette", path("curves.txt")}), 1) << text;
    EXPECT_THAT(output_, HasSubstr("curves.txt has no curves: a palette has 1 to 8"));
  }
}

TEST_F(FilterCommand, ASurfaceThatIsTooThinIsRefusedByItsFile) {
  folder_.write("thin.obj", "v 0 0 0\nv 1 0 0\nv 2 1e-14 0\nf 1 2 3\n");
  EXPECT_EQ(burnish({"filter", path("thin.obj"), path("o.obj"), "--depth", "4"}), 1);
  EXPECT_THAT(output_, HasSubstr("thin.obj: the grid of depth 4"));
  EXPECT_THAT(output_, HasSubstr("holds no surface"));
}

TEST_F(FilterCommand, AnErrorNamesStandardInputAndNoFileOfTheProgramsOwn) {
  for (const char* text : {"plx\n", "ply\nformat ascii 1.0\nend_header\n"}) {
    const std::string file = folder_.write("wrong.ply", text).string();
    Process process({"/bin/sh", "-c", "exec " BURNISH_BINARY " filter - - < " + file},
                    folder_ / "log", {});
    EXPECT_EQ(process.wait(kFilterPatience).value_or(-1), 1);
    EXPECT_THAT(process.output(), HasSubstr("standard input"));
    EXPECT_THAT(process.output(), Not(HasSubstr("/in.ply")));
  }
}

TEST_F(FilterCommand, OneRimIsToldInTheSingular) {
  ASSERT_TRUE(write_mesh(make_sheet(20, 1, 0.1), in()).is_ok());
  ASSERT_EQ(burnish({"filter", in(), out(), "--depth", "5", "--cycles", "1", "--beta", "0"}), 0);
  EXPECT_THAT(output_, HasSubstr("the one rim stays where it is; --pin-rims off lets it move"));
}

TEST_F(FilterCommand, AWrongInputFailsWithItsPlaceAndWritesNothing) {
  std::ofstream(path("bad.obj")) << "v 0 0 0\nv 1 0 0\nv 0 nan 0\nf 1 2 3\n";
  EXPECT_EQ(burnish({"filter", path("bad.obj"), out()}), 1);
  EXPECT_THAT(output_, HasSubstr("bad.obj"));
  EXPECT_EQ(burnish({"filter", path("absent.ply"), out()}), 1);
  EXPECT_THAT(output_, HasSubstr("absent.ply"));
  std::ofstream(path("cells")) << "0 0 0 10 10 1\n";
  EXPECT_EQ(burnish({"filter", in(), out(), "--depth", "5", "--cell-field", path("cells")}), 1);
  EXPECT_THAT(output_, HasSubstr("cell 0 0 0 holds no surface"));
  EXPECT_FALSE(std::filesystem::exists(out()));
}

TEST_F(FilterCommand, AFullDiskLeavesWhatWasThere) {
  std::ofstream(out()) << "mine";
  EXPECT_EQ(
      burnish({"filter", in(), out(), "--depth", "4", "--cycles", "1"}, {.file_bytes_max = 10'000}),
      1);
  EXPECT_THAT(output_, HasSubstr("File too large"));
  std::ifstream file(out());
  std::string text;
  file >> text;
  EXPECT_EQ(text, "mine");
}

TEST_F(FilterCommand, AnOutputThatCannotBeWrittenIsRefusedBeforeTheWork) {
  EXPECT_EQ(burnish({"filter", in(), path("out.off")}), 1);
  EXPECT_THAT(output_, HasSubstr("is written as .off"));
}

TEST_F(FilterCommand, BetaOneReturnsAFileOfItsFormatByteForByte) {
  const std::string off =
      "OFF\r\n# a tent\r\n4 2 0\r\n0 0 0\r\n1.0 0 0\r\n1 1 3e-1\r\n0 1 0\r\n"
      "4 0 1 2 3 0.5 0.5 0.5\r\n3 0 1 2\r\n";
  const std::string obj =
      "mtllib a.mtl\nv 0 0 0\nv 1.000 0 0\nv 1 1 0.3\nv 0 1 0\nvt 0 0\nvn 0 0 1\n"
      "usemtl a\nf 1/1/1 2/1/1 3/1/1 4/1/1\n";
  for (const auto& [name, content] : {std::pair("tent.off", off), std::pair("tent.obj", obj)}) {
    const std::string file = folder_.write(name, content).string();
    ASSERT_EQ(burnish({"filter", file, path("out-") + name, "--depth", "4", "--cycles", "2"}), 0)
        << output_;
    EXPECT_EQ(content_of(path("out-") + name), content);
    EXPECT_THAT(output_, Not(HasSubstr("warning")));
  }
}

struct TextFile {
  const char* name;
  std::string header, position, face;  ///< what begins each of them
  std::string footer = "";
  int first = 0;  ///< the number of the first vertex in faces
};

/// Returns a mesh as a text whose positions have three decimals.
std::string text_of(const TextFile& file, const TriangleMesh& mesh) {
  std::string text = file.header;
  const auto put_position = [&](uint32_t v) {
    const Vec3d& p = mesh.vertices[v];
    char line[100];
    std::snprintf(line, sizeof line, "%.3f %.3f %.3f\n", p[0], p[1], p[2]);
    text += file.position + line;
  };
  const bool is_soup = !file.footer.empty();
  for (uint32_t v = 0; v < mesh.vertices.size() && !is_soup; ++v) put_position(v);
  for (const Triangle& triangle : mesh.triangles) {
    text += file.face;
    for (const uint32_t v : triangle)
      is_soup ? put_position(v) : void(text += " " + std::to_string(v + file.first));
    text += is_soup ? "endloop\nendfacet\n" : "\n";
  }
  return text + file.footer;
}

/// Returns the most digits behind a point in a text.
size_t decimals_max(const std::string& text) {
  size_t most = 0;
  for (size_t at = text.find('.'); at != std::string::npos; at = text.find('.', at + 1)) {
    const size_t end = text.find_first_not_of("0123456789", at + 1);
    most = std::max(most, std::min(end, text.size()) - at - 1);
  }
  return most;
}

std::string ply_header_of(const TriangleMesh& mesh, const std::string& type) {
  return "ply\nformat ascii 1.0\nelement vertex " + std::to_string(mesh.vertices.size()) +
         "\nproperty " + type + " x\nproperty " + type + " y\nproperty " + type +
         " z\nelement face " + std::to_string(mesh.triangles.size()) +
         "\nproperty list uchar int vertex_indices\nend_header\n";
}

TEST_F(FilterCommand, ATextKeepsItsDecimalsAndTheAccuracyOfAnExport) {
  const TriangleMesh sphere = make_icosphere(3, 10);
  const std::string off = "OFF\n" + std::to_string(sphere.vertices.size()) + " " +
                          std::to_string(sphere.triangles.size()) + " 0\n";
  const std::vector<TextFile> files = {
      {"a.obj", "", "v ", "f", "", 1},
      {"a.off", off, "", "3"},
      {"float.ply", ply_header_of(sphere, "float"), "", "3"},
      {"double.ply", ply_header_of(sphere, "double"), "", "3"},
      {"a.stl", "solid s\n", "vertex ", "facet normal 0 0 0\nouter loop\n", "endsolid s\n"}};
  for (const TextFile& file : files) {
    const std::string text = text_of(file, sphere);
    TriangleMesh binary = read_mesh(folder_.write(file.name, text)).value();
    binary.has_double_positions = true;
    ASSERT_TRUE(write_mesh(binary, in()).is_ok());
    ASSERT_EQ(burnish({"filter", in(), out(), "--beta", "0.2", "--force"}), 0) << output_;
    const std::string written = path(std::string("out-") + file.name);
    ASSERT_EQ(burnish({"filter", path(file.name), written, "--beta", "0.2"}), 0) << output_;
    const std::string after = content_of(written);
    EXPECT_NE(after, text);
    EXPECT_LT(after.size(), text.size() * 4 / 3) << file.name;
    EXPECT_LE(decimals_max(after), 6) << file.name;
    const TriangleMesh as_text = read_mesh(written).value(), exact = read_mesh(out()).value();
    ASSERT_EQ(as_text.vertices.size(), exact.vertices.size());
    for (size_t v = 0; v < exact.vertices.size(); ++v)
      ASSERT_LT((as_text.vertices[v] - exact.vertices[v]).norm(), 1e-7 * 34.6) << file.name;
  }
}

TEST_F(FilterCommand, AnotherTextFormatHasTheDecimalsOfTheFile) {
  const TriangleMesh sphere = make_icosphere(3, 10);
  const TextFile file = {"double.ply", ply_header_of(sphere, "double"), "", "3"};
  folder_.write(file.name, text_of(file, sphere));
  ASSERT_EQ(burnish({"filter", path(file.name), path("out.obj"), "--beta", "0.2"}), 0) << output_;
  EXPECT_LE(decimals_max(content_of(path("out.obj"))), 6);
}

TEST_F(FilterCommand, AGlbComesBackByteForByteAndMovedInItsNodesFrame) {
  GlbFile tent = square_glb();
  tent.json["nodes"][0]["translation"] = {0, 0, 100};
  tent.json["meshes"][0]["primitives"][0]["material"] = 0;
  tent.json["materials"] = {{{"name", "clay"}}};
  for (const auto& [name, content] :
       {std::pair("tent.glb", tent.glb()), std::pair("tent.gltf", tent.gltf(2))}) {
    const std::string file = folder_.write(name, content).string();
    const std::string written = path(std::string("out-") + name);
    ASSERT_EQ(burnish({"filter", file, written, "--depth", "4", "--cycles", "2"}), 0) << output_;
    EXPECT_EQ(content_of(written), content);
    ASSERT_EQ(burnish({"filter", file, written, "--depth", "4", "--alpha", "2", "--beta", "0",
                       "--pin-rims", "off"}),
              0)
        << output_;
    EXPECT_THAT(content_of(written), HasSubstr("clay"));
    const TriangleMesh moved = read_mesh(written).value();
    ASSERT_EQ(moved.vertices.size(), 4u);
    EXPECT_LT((moved.vertices[2] - moved.vertices[0]).norm(), 1.3);
    EXPECT_NEAR(moved.vertices[0].z(), 100, 0.1);
  }
  ASSERT_EQ(burnish({"filter", path("tent.glb"), out(), "--depth", "4", "--cycles", "1"}), 0);
  EXPECT_THAT(output_, HasSubstr("materials"));
  ASSERT_EQ(burnish({"filter", in(), path("sphere.glb"), "--depth", "4", "--cycles", "1"}), 0);
  EXPECT_EQ(read_mesh(path("sphere.glb")).value().triangles.size(), 5120u);
}

TEST_F(FilterCommand, TheFilesOfAnObjFollowItIntoAnotherFolder) {
  const std::string obj =
      "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0.3\nvt 0 0\nusemtl a\nf 1/1 2/1 3/1\n";
  folder_.write("a.mtl", "newmtl a\nmap_Kd skin.gif\n");
  folder_.write("skin.gif", "pixels");
  std::filesystem::create_directory(path("other"));
  const std::vector<std::string> filter = {"filter",
                                           folder_.write("a.obj", obj).string(),
                                           path("other/b.obj"),
                                           "--depth",
                                           "4",
                                           "--cycles",
                                           "1"};
  ASSERT_EQ(burnish(filter), 0) << output_;
  EXPECT_EQ(content_of(path("other/b.obj")), obj);
  EXPECT_EQ(content_of(path("other/skin.gif")), "pixels");
  folder_.write("other/skin.gif", "mine");
  EXPECT_EQ(burnish(filter), 1);
  EXPECT_THAT(output_, HasSubstr("other/skin.gif"));
  EXPECT_EQ(content_of(path("other/skin.gif")), "mine");
}

TEST_F(FilterCommand, AnotherFormatWarnsOfWhatItLeavesOut) {
  const std::string obj = "v 0 0 0\nv 1 0 0\nv 1 1 0.3\nvt 0 0\nusemtl a\nf 1/1 2/1 3/1\n";
  ASSERT_EQ(burnish({"filter", folder_.write("a.obj", obj).string(), out(), "--depth", "4",
                     "--cycles", "1"}),
            0)
      << output_;
  EXPECT_THAT(output_, HasSubstr("texture coordinates, materials"));
}

TEST_F(FilterCommand, AnOutputInAFolderThatIsMissingIsRefusedBeforeTheWork) {
  EXPECT_EQ(burnish({"filter", in(), path("nowhere/out.ply")}), 1);
  EXPECT_THAT(output_, HasSubstr("nowhere/out.ply:"));
  EXPECT_THAT(output_, testing::Not(HasSubstr("curvature")));
}

TEST_F(FilterCommand, TheInputIsReplacedOnlyByForce) {
  const auto before = std::filesystem::file_size(in());
  EXPECT_EQ(burnish({"filter", in(), in(), "--depth", "4", "--cycles", "1"}), 1);
  EXPECT_THAT(output_, HasSubstr("--force"));
  EXPECT_EQ(std::filesystem::file_size(in()), before);
  EXPECT_EQ(burnish({"filter", in(), in(), "--depth", "4", "--cycles", "1", "--force"}), 0)
      << output_;
}

TEST_F(FilterCommand, ADepthBeyondTheMachinesMemoryIsRefusedWithWhatItTakes) {
  if (available_memory_bytes() > uint64_t{50} << 30) GTEST_SKIP() << "this machine can do it";
  TriangleMesh square;
  square.vertices = {{0, 0, 0}, {1, 0, 0.2}, {1, 1, 0.1}, {0, 1, 0.3}};
  square.triangles = {{0, 1, 2}, {0, 2, 3}};
  ASSERT_TRUE(write_mesh(square, path("square.ply")).is_ok());
  EXPECT_EQ(burnish({"filter", path("square.ply"), out(), "--depth", "12"}), 1);
  EXPECT_THAT(output_, HasSubstr("preparing 2 triangles at depth 12 takes"));
  EXPECT_THAT(output_, HasSubstr(" fits"));
  EXPECT_FALSE(std::filesystem::exists(out()));
}

}  // namespace
}  // namespace burnish
