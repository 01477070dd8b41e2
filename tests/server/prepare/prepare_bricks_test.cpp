#include <algorithm>

#include <gtest/gtest.h>

#include "common/generate/generate.h"
#include "server/prepare/prepare.h"
#include "server/prepare/prepared_file.h"
#include "tests/common/temporary_folder.h"
#include "tests/reference/awkward_meshes.h"

namespace burnish {
namespace {

constexpr int kBrickTestDepth = 6;
constexpr uint64_t kOneBrick = UINT64_MAX;

class PrepareInBricks : public testing::TestWithParam<std::string> {
 protected:
  TemporaryFolder folder_;
};

std::shared_ptr<const PreparedMesh> prepared_with(const TriangleMesh& mesh, uint64_t per_brick,
                                                  const ScratchSpace& space) {
  PrepareOptions options;
  options.depth = kBrickTestDepth;
  options.curvature_radius = 0.01;
  options.pieces_per_brick = per_brick;
  options.space = space;
  return prepare(mesh, options).value();
}

// The checksums of all sections are in the header.
void expect_same_file(const PreparedMesh& a, const PreparedMesh& b) {
  const PreparedHeader first = make_prepared_header(a), second = make_prepared_header(b);
  EXPECT_EQ(first.checksum, second.checksum);
  const auto sections = section_bytes(a), others = section_bytes(b);
  for (int i = 0; i < kPreparedSections; ++i)
    EXPECT_TRUE(std::ranges::equal(sections[i], others[i])) << "section " << i;
}

std::vector<Vec3d> positions_in_grid(const TriangleMesh& mesh) {
  const MeshStatistics statistics = compute_statistics(mesh);
  const GridFrame frame = make_grid_frame(statistics.box_min, statistics.box_max, kBrickTestDepth);
  std::vector<Vec3d> positions;
  for (const Vec3d& vertex : mesh.vertices)
    positions.push_back(snap_to_planes(frame.to_grid(vertex)));
  return positions;
}

TEST_P(PrepareInBricks, GivesTheBytesOfOneBrick) {
  const TriangleMesh mesh = generate_scan({GetParam(), 5000, 1}).value();
  const auto whole = prepared_with(mesh, kOneBrick, {});
  const std::vector<Vec3d> positions = positions_in_grid(mesh);
  const uint64_t pieces =
      count_cell_pieces({mesh.triangles, positions, kBrickTestDepth}, UINT64_MAX, {})->total();
  for (const uint64_t per_brick : {pieces / 7, uint64_t{100}, uint64_t{1}})
    expect_same_file(*whole, *prepared_with(mesh, per_brick, {}));
}

TEST_P(PrepareInBricks, GivesTheSameBytesWithAllArraysInFiles) {
  const TriangleMesh mesh = generate_scan({GetParam(), 5000, 1}).value();
  const ScratchSpace files(folder_.path(), 0);
  const auto in_files = prepared_with(mesh, 1000, files);
  EXPECT_EQ(files.memory_bytes(), 0u);
  EXPECT_EQ(folder_.file_count(), 0u);
  expect_same_file(*prepared_with(mesh, kOneBrick, {}), *in_files);
}

INSTANTIATE_TEST_SUITE_P(Kinds, PrepareInBricks,
                         testing::Values("tablet", "icosphere", "cylinder", "sheet", "blob",
                                         "sheets", "fan", "soup", "part"),
                         [](const auto& test) { return test.param; });

TEST(Bricks, HoldWholeBucketsUpToTheirLimit) {
  const PieceCount count = {0, {0, 3, 3, 5, 15, 16, 20}};  // 3, 0, 2, 10, 1 and 4 pieces
  const Bricks bricks = make_bricks(count, 5);
  EXPECT_EQ(bricks.start, (std::vector<uint64_t>{0, 5, 15, 20}));
  EXPECT_EQ(bricks.of_bucket, (std::vector<uint32_t>{0, 0, 0, 1, 2, 2}));
}

TEST(PieceCount, AddsUpToThePiecesThatAreFound) {
  for (const auto& [name, mesh] : reference::awkward_meshes()) {
    SCOPED_TRACE(name);
    const std::vector<Vec3d> positions = positions_in_grid(mesh);
    const GridMesh in_grid = {mesh.triangles, positions, kBrickTestDepth};
    const auto count = count_cell_pieces(in_grid, UINT64_MAX, {});
    const auto pieces = find_cell_pieces(in_grid, *count, {{}, 10}, {});
    EXPECT_EQ(pieces->size(), count->total());
    EXPECT_TRUE(std::ranges::is_sorted(
        *pieces, {}, [](const CellPiece& piece) { return std::pair(piece.cell, piece.triangle); }));
  }
}

}  // namespace
}  // namespace burnish
