// A local new metric has the bits of a whole one: matrices, pins, kept numbers, smoothers, patches.

#include <algorithm>
#include <numeric>
#include <random>

#include <gtest/gtest.h>

#include "server/solver/cpu/assembly/assembly.h"
#include "server/solver/cpu/smoothers/patch_solver.h"
#include "server/solver/cpu/smoothers/smoother.h"
#include "server/solver/hierarchy/changed_parts.h"
#include "tests/reference/awkward_meshes.h"
#include "tests/reference/shapes.h"
#include "tests/server/solver/test_system.h"

namespace burnish::cpu {
namespace {

/// Everything that a backend makes of α.
struct Made {
  Made(const TestSystem& on, CellAlphas of)
      : system(on),
        alphas(std::move(of)),
        exact(on.hierarchy->depths.back().stencil),
        patches(on.plan->patches) {
    depths.reserve(on.hierarchy->depths.size());
    for (const HierarchyDepth& topology : on.hierarchy->depths) {
      depths.emplace_back(topology);
      smoothers.push_back(make_schwarz(topology));
    }
    assemble(*system.prepared, alphas, depths, &exact);
    for (size_t d = 1; d < depths.size(); ++d) smoothers[d]->set_up(depths[d]);
    patches.factor(depths.back());
    for (CpuDepth& depth : depths) depth.is_spectrum_new = false;  // its estimate has a history
  }

  void make_whole(const CellAlphas& of) {
    assemble(*system.prepared, of, depths, &exact);
    for (size_t d = 1; d < depths.size(); ++d) smoothers[d]->set_up(depths[d]);
    patches.factor(depths.back());
  }

  void update(const CellAlphas& of, std::span<const int32_t> cells) {
    auto changed = find_changed_parts(*system.prepared, *system.hierarchy, cells, kDepthsNotKept);
    assemble_changed(*system.prepared, of, changed, depths, &exact);
    for (size_t d = 1; d < depths.size(); ++d) smoothers[d]->update(depths[d], changed[d].rows);
    patches.factor(depths.back(), changed.back().rows);
  }

  std::vector<float> relaxed(size_t d) {
    std::minstd_rand random(7);
    CpuDepth& depth = depths[d];
    for (auto& f : depth.f) f = Float4::Constant(static_cast<float>(random() % 1000));
    smoothers[d]->relax_from_zero(depth);
    if (d + 1 == depths.size()) patches.relax_forwards(depth);
    std::vector<float> x;
    for (const Float4& value : depth.x) x.push_back(value[0]);
    return x;
  }

  const TestSystem& system;
  CellAlphas alphas;
  std::vector<CpuDepth> depths;
  std::vector<std::unique_ptr<DepthSmoother>> smoothers;
  ExactMatrix exact;
  PatchSolver patches;
};

void expect_same_bits(Made& local, Made& whole) {
  EXPECT_EQ(local.exact.entry, whole.exact.entry);
  EXPECT_EQ(local.exact.row_sum, whole.exact.row_sum);
  for (size_t d = 0; d < whole.depths.size(); ++d) {
    SCOPED_TRACE("depth " + std::to_string(whole.depths[d].topology.grid.depth));
    EXPECT_EQ(local.depths[d].system.entry, whole.depths[d].system.entry);
    EXPECT_EQ(local.depths[d].system.diagonal, whole.depths[d].system.diagonal);
    EXPECT_EQ(local.depths[d].inverse_diagonal, whole.depths[d].inverse_diagonal);
    EXPECT_EQ(local.depths[d].kept_numbers, whole.depths[d].kept_numbers);
    if (d == 0) continue;
    EXPECT_EQ(local.relaxed(d), whole.relaxed(d));
  }
}

/// Returns some cells: a few anywhere, or all near one of them.
std::vector<int32_t> random_cells(const PreparedMesh& prepared, std::minstd_rand& random) {
  const auto count = static_cast<int32_t>(prepared.cells.size());
  std::vector<int32_t> cells;
  const bool is_ball = random() % 2 == 0;
  const Vec3i middle = morton_point(prepared.cells[random() % count]);
  const int every = 1 + static_cast<int>(random() % 200), radius = static_cast<int>(random() % 6);
  for (int32_t c = 0; c < count; ++c) {
    const Vec3i away = (morton_point(prepared.cells[c]) - middle).cwiseAbs();
    if (is_ball ? away.maxCoeff() <= radius : static_cast<int>(random() % every) == 0)
      cells.push_back(c);
  }
  return cells;
}

/// Gives the cells other α: up to four thousand times as much, and up to a hundred apart.
void change(CellAlphas& alphas, std::span<const int32_t> cells, std::minstd_rand& random) {
  const auto factor = [&](double contrast) {
    return static_cast<float>(std::pow(contrast, static_cast<double>(random() % 1000) / 1000));
  };
  for (const int32_t c : cells) {
    alphas.alpha1[c] = 0.5f * factor(4000);
    alphas.alpha2[c] = alphas.alpha1[c] * factor(100) / 10;
  }
}

void expect_local_is_whole(const TriangleMesh& mesh, int depth, int changes) {
  const TestSystem system(mesh, depth);
  std::minstd_rand random(3);
  CellAlphas alphas = system.fields.alphas();
  Made local(system, alphas), whole(system, alphas);
  for (int i = 0; i < changes; ++i) {
    SCOPED_TRACE("change " + std::to_string(i));
    const std::vector<int32_t> cells = random_cells(*system.prepared, random);
    change(alphas, cells, random);
    local.update(alphas, cells);
    whole.make_whole(alphas);
    expect_same_bits(local, whole);
  }
}

TEST(ChangedAssembly, HasTheBitsOfTheWholeOnAwkwardScans) {
  for (const auto& [name, mesh] : reference::awkward_meshes()) {
    SCOPED_TRACE(name);
    expect_local_is_whole(mesh, 6, 4);
  }
}

TEST(ChangedAssembly, HasTheBitsOfTheWholeWithDepthsThatKeepNumbers) {
  const TestSystem system(reference::bumpy_sphere(5), 7);
  const auto depths = system.assembled();
  EXPECT_GT(depths.size(), kDepthsNotKept);
  EXPECT_FALSE(depths.front().kept_numbers.empty());
  EXPECT_TRUE(depths.back().kept_numbers.empty());
  expect_local_is_whole(reference::bumpy_sphere(5), 7, 4);
  expect_local_is_whole(reference::several_components(), 7, 4);
}

TEST(ChangedAssembly, PinsAndFreesCornersFarFromTheChange) {
  const TestSystem system(reference::bumpy_sphere(4), 6);
  CellAlphas alphas = system.fields.alphas();
  Made local(system, alphas), whole(system, alphas);
  std::vector<int32_t> cells(system.prepared->cells.size() * 3 / 4);
  std::iota(cells.begin(), cells.end(), 0);
  for (const int32_t c : cells) alphas.alpha1[c] = alphas.alpha2[c] = 5000;
  const std::vector<float> before = local.depths.back().inverse_diagonal;
  local.update(alphas, cells);
  whole.make_whole(alphas);
  expect_same_bits(local, whole);
  const auto pinned = [](const std::vector<float>& of) { return std::ranges::count(of, 0.0f); };
  EXPECT_NE(pinned(before), pinned(local.depths.back().inverse_diagonal));
}

TEST(ChangedAssembly, MakesFewRowsAgainForFewCells) {
  const TestSystem system(reference::bumpy_sphere(5), 8);
  const std::vector<int32_t> cell = {17};
  const auto changed =
      find_changed_parts(*system.prepared, *system.hierarchy, cell, kDepthsNotKept);
  EXPECT_EQ(changed.back().parts, cell);
  EXPECT_EQ(changed.back().rows.size(), 8u);
  EXPECT_LT(changed.back().needed.size(), system.prepared->cells.size() / 20);
  for (const ChangedDepth& depth : changed) EXPECT_LE(depth.rows.size(), 8u);
}

}  // namespace
}  // namespace burnish::cpu
