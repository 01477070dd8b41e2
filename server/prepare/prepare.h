#pragma once

#include <memory>

#include "common/base/progress.h"
#include "common/base/status.h"
#include "common/mesh/triangle_mesh.h"
#include "server/prepare/preparation_need.h"
#include "server/prepare/prepared_mesh.h"

namespace burnish {

struct PrepareOptions {
  int depth = 0;                        ///< 0 chooses: default_depth()
  double curvature_radius = 0;          ///< averaging radius for κ as a fraction of L, 0 for none
  int threads = 0;                      ///< 0: all cores
  PreparationBudget* budget = nullptr;  ///< what it may take; null: what the machine has
};

/// Runs the whole pipeline: grid, curvature, clipping, integrals, evaluation, histogram.
/// Source: section 5.1. Needs: a valid mesh (validate()).
/// Asks the budget before it takes memory, and once more whenever it has counted more.
/// Fails: invalid_argument (depth or radius outside its limits; no triangle with area);
/// resource_exhausted naming depth, bytes and limit, and the deepest depth that fits; cancelled.
/// Deterministic: the same bits for any thread count.
Result<std::shared_ptr<const PreparedMesh>> prepare(const TriangleMesh& mesh,
                                                    const PrepareOptions& options,
                                                    const Progress& progress = {},
                                                    PrepareReport* report = nullptr);

}  // namespace burnish
