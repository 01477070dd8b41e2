#include "tests/common/frame_codec/small_scan.h"

#include <set>

#include "common/generate/generate.h"
#include "common/mesh/statistics.h"

namespace burnish {

static SmallScan make_small_scan() {
  constexpr int kDepth = 6;
  SmallScan scan;
  scan.mesh = generate_scan({.kind = "blob", .vertices = 5000}).value();
  Vec3d least = scan.mesh.vertices[0], greatest = least;
  for (const Vec3d& vertex : scan.mesh.vertices) {
    least = least.cwiseMin(vertex);
    greatest = greatest.cwiseMax(vertex);
  }
  scan.frame = make_grid_frame(least, greatest, kDepth);
  std::set<MortonKey> cells;
  for (const Vec3d& vertex : scan.mesh.vertices) {
    const Vec3d inside = snap_to_planes(scan.frame.to_grid(vertex));
    cells.insert(morton_key(inside.array().floor().cast<int>()));
  }
  scan.grid = make_finest_grid(kDepth, std::vector<MortonKey>(cells.begin(), cells.end()));
  scan.points = make_evaluation(scan.mesh, scan.frame, scan.grid);
  return scan;
}

const SmallScan& small_scan() {
  static const SmallScan scan = make_small_scan();
  return scan;
}

std::shared_ptr<const FrameLayout> small_layout(FrameContent content) {
  const FrameMesh mesh = small_scan().frame_mesh();
  return std::make_shared<FrameLayout>(content == FrameContent::kCoefficients
                                           ? make_coefficient_layout(mesh)
                                           : make_vertex_layout(mesh));
}

std::vector<Vec3d> wavy_displacement(const SparseGrid& grid, double amplitude, double phase) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> noise(-0.02, 0.02);
  std::vector<Vec3d> displacement;
  for (const GridKey& corner : grid.corners) {
    const Vec3d p = morton_point(corner.place).cast<double>();
    const Vec3d wave(std::sin(0.3 * p.x() + phase), std::cos(0.2 * p.y() - phase),
                     std::sin(0.25 * (p.x() + p.z()) + phase));
    displacement.emplace_back(amplitude * (wave + Vec3d(noise(random), noise(random), 0)));
  }
  return displacement;
}

FrameSample sample_of(const FrameLayout& layout, std::span<const Vec3d> displacement) {
  return sample_displacement(layout, small_scan().frame_mesh(), displacement).value();
}

std::vector<int32_t> steps_of(const FrameLayout& layout, const FrameState& state) {
  std::vector<int32_t> steps(size_t{3} * layout.value_count());
  for (int tile = 0; tile < layout.tile_count(); ++tile)
    state.read_tile(tile, std::span(steps).subspan(size_t{3} * layout.tile_begin(tile),
                                                   size_t{3} * layout.tile_size(tile)));
  return steps;
}

void change_some_tiles(const FrameLayout& layout, std::mt19937& random, FrameSample& sample) {
  const auto dice = [&random](int sides) {
    return static_cast<int>(random() % static_cast<unsigned>(sides));
  };
  for (int tile = 0; tile < layout.tile_count(); ++tile) {
    if (dice(2) == 0) continue;
    const int reach = dice(6) == 0 ? 1 << 20 : 40;
    const size_t begin = size_t{3} * layout.tile_begin(tile);
    for (int i = 0; i < 3 * layout.tile_size(tile); ++i)
      if (dice(3) == 0) sample.steps[begin + i] += dice(2 * reach + 1) - reach;
  }
}

}  // namespace burnish
