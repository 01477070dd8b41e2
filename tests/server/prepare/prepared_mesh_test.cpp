#include "server/prepare/prepared_mesh.h"

#include <cstring>
#include <functional>
#include <limits>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "server/prepare/prepared_file.h"
#include "tests/common/base/file_size_limit.h"
#include "tests/common/temporary_folder.h"

namespace burnish {
namespace {

using testing::AllOf;
using testing::HasSubstr;

// A small mesh with distinct values; their meaning does not matter to the file.
struct Sample {
  std::vector<Vec3d> vertices = {{0, 0, 0}, {1, 0, 0.5}, {0, 1, 0}, {0.25, 1, 1}};
  std::vector<Triangle> triangles = {{0, 1, 2}, {1, 3, 2}};
  std::vector<Rgba8> colours = {{1, 2, 3, 255}, {4, 5, 6, 255}, {7, 8, 9, 255}, {10, 11, 12, 0}};
  std::vector<EvaluationPoint> evaluation = {
      {0, {0, 0.5f, 1}}, {2, {0.25f, 0, 0}}, {1, {1, 1, 1}}, {kNone, {}}};
  std::vector<MortonKey> cells = {7, 500, 4095};
  std::vector<CellIntegrals> integrals = std::vector<CellIntegrals>(3);
  std::vector<CellCurvature> curvature = {{2, -1, 0.5f}, {3, 1, 0.25f}, {0, 0, 0.125f}};
  std::vector<uint32_t> passages = {0, 1u << 26, 1};
  std::vector<CellSheet> sheets = {{1, 0, 1u << 26}, {1, 3, 0}};
  std::vector<CellIntegrals> sheet_integrals = std::vector<CellIntegrals>(2);

  PreparedMesh mesh() {
    for (size_t c = 0; c < integrals.size(); ++c) {
      integrals[c].mass.fill(1.5f + static_cast<float>(c));
      integrals[c].stiffness[1].fill(-0.5f);
    }
    PreparedMesh mesh;
    mesh.frame = {Vec3d(-1, -2, -3), 0.125, 4};
    mesh.length_unit = 1.25;
    mesh.curvature_radius = 0.01;
    mesh.statistics = {4, 2, 3, 1, 1, 0, 1, 1.5625, -0.1, 1.2, {0, 0, 0}, {1, 1, 1}};
    mesh.has_double_positions = true;
    mesh.histogram.range = 40;
    mesh.histogram.area[5] = 0.75f;
    mesh.walls = {0.25, 9};
    mesh.vertices = vertices;
    mesh.triangles = triangles;
    mesh.colours = colours;
    mesh.evaluation = evaluation;
    mesh.cells = cells;
    mesh.integrals = integrals;
    mesh.curvature = curvature;
    mesh.passages = passages;
    mesh.sheets = sheets;
    mesh.sheet_integrals = sheet_integrals;
    return mesh;
  }
};

template <typename T>
bool same_bytes(std::span<const T> a, std::span<const T> b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size_bytes()) == 0;
}

class PreparedFile : public testing::Test {
 protected:
  Status map_status(const std::string& content) {
    return read_prepared_mesh(folder_.write("scan.prepared", content)).status();
  }
  std::string written(const PreparedMesh& mesh) {
    EXPECT_TRUE(write_prepared_mesh(mesh, folder_ / "written").is_ok());
    return content_of(folder_ / "written");
  }
  // Returns the status of a file whose mesh contradicts itself, with correct checksums.
  Status status_of_lie(const std::function<void(Sample&)>& lie) {
    Sample sample;
    lie(sample);
    return map_status(written(sample.mesh()));
  }
  // Returns the status of a file with a changed header and its correct checksum.
  Status status_of_header(const std::function<void(PreparedHeader&)>& change) {
    std::string content = written(Sample().mesh());
    PreparedHeader header;
    std::memcpy(&header, content.data(), sizeof(header));
    change(header);
    header.checksum = header_checksum(header);
    std::memcpy(content.data(), &header, sizeof(header));
    return map_status(content);
  }

  TemporaryFolder folder_;
};

void expect_damage(const Status& status, const std::string& what) {
  EXPECT_EQ(status.code(), StatusCode::kDataLoss);
  EXPECT_THAT(status.message(), AllOf(HasSubstr("scan.prepared"), HasSubstr(what)));
}

TEST_F(PreparedFile, MapsBackEveryBit) {
  Sample sample;
  const PreparedMesh mesh = sample.mesh();
  ASSERT_TRUE(write_prepared_mesh(mesh, folder_ / "file").is_ok());
  const auto mapped = read_prepared_mesh(folder_ / "file");
  ASSERT_TRUE(mapped.is_ok()) << mapped.status().message();
  const PreparedMesh& back = **mapped;
  EXPECT_TRUE(same_bytes(back.vertices, mesh.vertices));
  EXPECT_TRUE(same_bytes(back.triangles, mesh.triangles));
  EXPECT_TRUE(same_bytes(back.colours, mesh.colours));
  EXPECT_TRUE(same_bytes(back.evaluation, mesh.evaluation));
  EXPECT_TRUE(same_bytes(back.cells, mesh.cells));
  EXPECT_TRUE(same_bytes(back.integrals, mesh.integrals));
  EXPECT_TRUE(same_bytes(back.curvature, mesh.curvature));
  EXPECT_TRUE(same_bytes(back.passages, mesh.passages));
  EXPECT_TRUE(same_bytes(back.sheets, mesh.sheets));
  EXPECT_TRUE(same_bytes(back.sheet_integrals, mesh.sheet_integrals));
  EXPECT_EQ(back.frame.origin, mesh.frame.origin);
  EXPECT_EQ(back.frame.cell_size, mesh.frame.cell_size);
  EXPECT_EQ(back.frame.depth, mesh.frame.depth);
  EXPECT_EQ(back.length_unit, mesh.length_unit);
  EXPECT_EQ(back.curvature_radius, mesh.curvature_radius);
  EXPECT_TRUE(back.has_double_positions);
  EXPECT_EQ(back.histogram.range, mesh.histogram.range);
  EXPECT_EQ(back.histogram.area, mesh.histogram.area);
  EXPECT_EQ(back.walls.share, mesh.walls.share);
  EXPECT_EQ(back.walls.depth, mesh.walls.depth);
  EXPECT_EQ(back.byte_count(), mesh.byte_count());
}

TEST_F(PreparedFile, MapsBackTheStatistics) {
  Sample sample;
  const MeshStatistics wanted = sample.mesh().statistics;
  ASSERT_TRUE(write_prepared_mesh(sample.mesh(), folder_ / "file").is_ok());
  const auto mapped = read_prepared_mesh(folder_ / "file");
  ASSERT_TRUE(mapped.is_ok());
  const MeshStatistics& back = (*mapped)->statistics;
  EXPECT_EQ(back.vertices, wanted.vertices);
  EXPECT_EQ(back.triangles, wanted.triangles);
  EXPECT_EQ(back.boundary_edges, wanted.boundary_edges);
  EXPECT_EQ(back.non_manifold_edges, wanted.non_manifold_edges);
  EXPECT_EQ(back.components, wanted.components);
  EXPECT_EQ(back.zero_area_triangles, wanted.zero_area_triangles);
  EXPECT_EQ(back.unreferenced_vertices, wanted.unreferenced_vertices);
  EXPECT_EQ(back.area, wanted.area);
  EXPECT_EQ(back.signed_volume, wanted.signed_volume);
  EXPECT_EQ(back.mean_edge_length, wanted.mean_edge_length);
  EXPECT_EQ(back.box_min, wanted.box_min);
  EXPECT_EQ(back.box_max, wanted.box_max);
}

TEST_F(PreparedFile, SectionsStartAtMultiplesOf64) {
  Sample sample;
  const PreparedHeader header = make_prepared_header(sample.mesh());
  for (const SectionEntry& entry : header.sections) EXPECT_EQ(entry.offset % 64, 0u);
}

TEST_F(PreparedFile, ColoursAreOptional) {
  EXPECT_TRUE(status_of_lie([](Sample& s) { s.colours.clear(); }).is_ok());
}

TEST_F(PreparedFile, TheSameMeshGivesTheSameFile) {
  EXPECT_EQ(written(Sample().mesh()), written(Sample().mesh()));
}

TEST_F(PreparedFile, AMissingFileIsNotFound) {
  EXPECT_EQ(read_prepared_mesh(folder_ / "nothing").status().code(), StatusCode::kNotFound);
}

TEST_F(PreparedFile, AFlippedByteIsFoundAndItsSectionNamed) {
  static constexpr const char* kSections[] = {
      "vertices",  "triangles", "colours",  "evaluation", "cells",
      "integrals", "curvature", "passages", "sheets",     "sheet integrals"};
  const std::string good = written(Sample().mesh());
  PreparedHeader header;
  std::memcpy(&header, good.data(), sizeof(header));
  for (const SectionEntry& entry : header.sections) {
    for (uint64_t i = 0; i < entry.count * entry.element_bytes; i += 5) {
      std::string bad = good;
      bad[entry.offset + i] ^= 0x10;
      expect_damage(map_status(bad), std::string(kSections[entry.id]) + ": checksum");
    }
  }
}

TEST_F(PreparedFile, AFlippedByteInTheHeaderIsFound) {
  const std::string good = written(Sample().mesh());
  for (size_t i = 0; i < sizeof(PreparedHeader); ++i) {
    std::string bad = good;
    bad[i] ^= 1;
    expect_damage(map_status(bad), "header: ");
  }
}

TEST_F(PreparedFile, AnyOtherLengthIsRefused) {
  const std::string good = written(Sample().mesh());
  for (size_t length = 0; length < good.size(); length += 13)
    expect_damage(map_status(good.substr(0, length)), "length of the file");
  expect_damage(map_status(good.substr(0, good.size() - 1)), "length of the file");
  expect_damage(map_status(good + "x"), "length of the file");
}

TEST_F(PreparedFile, AnotherVersionOrAnotherKindOfFileIsRefused) {
  expect_damage(status_of_header([](PreparedHeader& h) { ++h.version; }),
                "format version is " + std::to_string(kPreparedFormatVersion + 1));
  expect_damage(map_status("ply\n" + std::string(2000, ' ')), "not a prepared mesh");
}

TEST_F(PreparedFile, ALyingTableIsRefused) {
  const auto status_of_entry = [&](int section, const std::function<void(SectionEntry&)>& change) {
    return status_of_header([&](PreparedHeader& h) { change(h.sections[section]); });
  };
  for (uint64_t count : {uint64_t{0}, uint64_t{5}, uint64_t{1} << 40, ~uint64_t{0}}) {
    for (int section = 0; section < kPreparedSections; ++section)
      expect_damage(status_of_entry(section, [&](SectionEntry& e) { e.count = count; }), "");
  }
  expect_damage(status_of_entry(1, [](SectionEntry& e) { e.id = 2; }), "triangles: id");
  expect_damage(status_of_entry(4, [](SectionEntry& e) { e.element_bytes = 4; }),
                "cells: element size is 4, must be 8");
  expect_damage(status_of_entry(5, [](SectionEntry& e) { e.element_bytes = 0; }),
                "integrals: element size");
  expect_damage(status_of_entry(3, [](SectionEntry& e) { e.offset = ~uint64_t{63}; }),
                "evaluation: offset");
}

TEST_F(PreparedFile, ALyingLengthIsRefused) {
  for (uint64_t bytes : {uint64_t{0}, uint64_t{sizeof(PreparedHeader)}, ~uint64_t{0}})
    expect_damage(status_of_header([&](PreparedHeader& h) { h.file_bytes = bytes; }), "length");
}

TEST_F(PreparedFile, CountsThatContradictEachOtherAreRefused) {
  expect_damage(status_of_lie([](Sample& s) { s.colours.pop_back(); }), "colours: count is 3");
  expect_damage(status_of_lie([](Sample& s) { s.evaluation.pop_back(); }), "evaluation: count");
  expect_damage(status_of_lie([](Sample& s) { s.integrals.resize(4); }), "integrals: count is 4");
  expect_damage(status_of_lie([](Sample& s) { s.curvature.clear(); }), "curvature: count is 0");
  expect_damage(status_of_lie([](Sample& s) { s.passages.resize(2); }), "passages: count is 2");
  expect_damage(status_of_lie([](Sample& s) { s.sheet_integrals.pop_back(); }),
                "sheet integrals: count is 1");
  expect_damage(status_of_lie([](Sample& s) { s.vertices.pop_back(); }), "vertices: count is 3");
  expect_damage(status_of_lie([](Sample& s) { s.triangles.pop_back(); }), "triangles: count is 1");
}

TEST_F(PreparedFile, SheetsThatContradictTheirCellsAreRefused) {
  expect_damage(status_of_lie([](Sample& s) { s.sheets[1].cell = 3; }),
                "sheet 1 names cell 3 of 3");
  expect_damage(status_of_lie([](Sample& s) { s.sheets[0].cell = -1; }), "sheet 0 names cell -1");
  expect_damage(status_of_lie([](Sample& s) { s.sheets[1].component = 0; }),
                "sheet 1 is not above");
  expect_damage(status_of_lie([](Sample& s) { s.sheets[1].passages = 2; }),
                "sheet 1 has passages that its cell 1 does not have");
  expect_damage(status_of_lie([](Sample& s) {
                  for (uint32_t i = 4; i < 12; ++i) s.sheets.push_back({1, i, 0});
                  s.sheet_integrals.resize(s.sheets.size());
                }),
                "number 9 of cell 1, the limit is 8");
}

TEST_F(PreparedFile, IndicesOutsideTheirArraysAreRefused) {
  expect_damage(status_of_lie([](Sample& s) { s.triangles[1][2] = 4; }),
                "triangle 1 refers to vertex 4 of 4");
  expect_damage(status_of_lie([](Sample& s) { s.evaluation[1].cell = 3; }),
                "vertex 1 lies in cell 3 of 3");
  expect_damage(status_of_lie([](Sample& s) { s.evaluation[0].cell = -2; }), "cell -2");
  expect_damage(status_of_lie([](Sample& s) { s.cells[1] = 7; }), "cell 1 is not above");
  expect_damage(status_of_lie([](Sample& s) { s.cells[2] = 4096; }),
                "key 4096 of cell 2 is outside the grid of depth 4");
}

TEST_F(PreparedFile, PassagesToNoNeighbourAreRefused) {
  for (const int bit : {13, 27, 28, 29, 30, 31})
    expect_damage(status_of_lie([&](Sample& s) { s.passages[1] |= uint32_t{1} << bit; }),
                  "passages: bit " + std::to_string(bit) + " of cell 1");
}

TEST_F(PreparedFile, ScalarsOutsideTheirRangeAreRefused) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  expect_damage(status_of_header([](PreparedHeader& h) { h.depth = 13; }), "depth is 13");
  expect_damage(status_of_header([&](PreparedHeader& h) { h.grid_origin[1] = nan; }), "origin");
  expect_damage(status_of_header([](PreparedHeader& h) { h.cell_size = 0; }), "cell size");
  expect_damage(status_of_header([&](PreparedHeader& h) { h.length_unit = infinity; }), "length");
  expect_damage(status_of_header([&](PreparedHeader& h) { h.area = -1; }), "area");
  expect_damage(status_of_header([&](PreparedHeader& h) { h.box_max[2] = nan; }), "box");
  expect_damage(status_of_header([](PreparedHeader& h) { h.has_double_positions = 2; }), "double");
  expect_damage(status_of_header([](PreparedHeader& h) { h.histogram_area[9] = -1; }), "histogram");
  expect_damage(status_of_header([&](PreparedHeader& h) { h.walls_share = nan; }), "share of thin");
  expect_damage(status_of_header([](PreparedHeader& h) { h.walls_depth = 13; }), "depth of thin");
}

TEST_F(PreparedFile, AFailedWriteLeavesTheOldFile) {
  const auto path = folder_.write("scan.prepared", "old");
  Sample sample;
  const FileSizeLimit limit(1024);
  EXPECT_EQ(write_prepared_mesh(sample.mesh(), path).code(), StatusCode::kResourceExhausted);
  EXPECT_EQ(content_of(path), "old");
  EXPECT_EQ(folder_.file_count(), 1u);
}

TEST_F(PreparedFile, AMappedMeshOutlivesTheFilesName) {
  Sample sample;
  ASSERT_TRUE(write_prepared_mesh(sample.mesh(), folder_ / "file").is_ok());
  const auto mapped = read_prepared_mesh(folder_ / "file");
  std::filesystem::remove(folder_ / "file");
  ASSERT_TRUE(mapped.is_ok());
  EXPECT_EQ((*mapped)->cells.back(), 4095u);
}

}  // namespace
}  // namespace burnish
