#include "tests/server/solver/test_system.h"

#include <cmath>

#include "server/prepare/prepare.h"
#include "server/solver/cpu/assembly/assembly.h"
#include "server/solver/hierarchy/half_way.h"
#include "server/solver/tuning/plan_cycle.h"

namespace burnish {

static std::shared_ptr<const PreparedMesh> prepared_at(const TriangleMesh& mesh, int depth) {
  PrepareOptions options;
  options.depth = depth;
  return *prepare(mesh, options);
}

TestSystem::TestSystem(const TriangleMesh& mesh, int depth)
    : Multigrid(make_multigrid(prepared_at(mesh, depth)).value()), fields(*prepared) {}

std::vector<cpu::CpuDepth> TestSystem::assembled(cpu::ExactMatrix* exact) const {
  std::vector<cpu::CpuDepth> depths;
  depths.reserve(hierarchy->depths.size());
  for (const HierarchyDepth& topology : hierarchy->depths) depths.emplace_back(topology);
  cpu::assemble(*prepared, fields.alphas(), depths, exact);
  return depths;
}

TransferCurve test_curve(double contrast) {
  const double half = std::sqrt(contrast);
  return *TransferCurve::create({{-10, 50 * half}, {10, 50 / half}});
}

Sparse system_matrix(const cpu::CpuDepth& depth) {
  const Stencil& stencil = depth.topology.stencil;
  std::vector<Eigen::Triplet<double>> entries;
  for (int32_t i = 0; i < depth.corner_count(); ++i) {
    for (auto [k, end] = stencil.row(i); k < end; ++k)
      entries.emplace_back(i, stencil.column[k], depth.system.entry[k]);
    entries.emplace_back(i, i, depth.system.diagonal[i]);
  }
  Sparse matrix(depth.corner_count(), depth.corner_count());
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

Sparse prolongation_matrix(const HierarchyDepth& fine, const HierarchyDepth& coarse) {
  std::vector<Eigen::Triplet<double>> entries;
  for (int32_t i = 0; i < fine.grid.corner_count(); ++i) {
    if (fine.to_parent.is_shared(i)) continue;
    const FromCell from = fine.to_parent.prolongation[i];
    for (int a = 0; a < kCornersPerCell; ++a)
      if (half_way_weights()[from.place][a] > 0)
        entries.emplace_back(i, coarse.grid.cell_corners[from.cell][a],
                             half_way_weights()[from.place][a]);
  }
  const DepthTransfer::SharedCorners& shared = fine.to_parent.shared;
  for (int32_t i = 0; i < shared.count(); ++i)
    for (int32_t k = shared.start[i]; k < shared.start[i + 1]; ++k)
      entries.emplace_back(shared.corner[i], shared.coarse_corner[k], shared.weight[k]);
  Sparse matrix(fine.grid.corner_count(), coarse.grid.corner_count());
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

}  // namespace burnish
