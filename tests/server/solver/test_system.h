#pragma once

#include <Eigen/Sparse>

#include "server/fields/fields.h"
#include "server/solver/cpu/cpu_depth.h"
#include "server/solver/cycle/multigrid.h"

namespace burnish {

using Sparse = Eigen::SparseMatrix<double>;

/// A mesh prepared at a depth, with its hierarchy, plan and fields.
struct TestSystem : Multigrid {
  TestSystem(const TriangleMesh& mesh, int depth);

  Fields fields;

  /// Returns the matrices of all depths, the coarsest first, as the CPU backend makes them of the
  /// fields.
  std::vector<cpu::CpuDepth> assembled(cpu::ExactMatrix* exact = nullptr) const;
};

/// Returns a curve of strong anisotropy: α1 and α2 differ by up to `contrast` over curvatures at a
/// unit sphere's scale.
TransferCurve test_curve(double contrast);

/// Returns S of one depth, with rows and columns of pinned corners.
Sparse system_matrix(const cpu::CpuDepth& depth);

/// Returns P from the coarser depth to `fine`.
Sparse prolongation_matrix(const HierarchyDepth& fine, const HierarchyDepth& coarse);

}  // namespace burnish
