#pragma once

#include <memory>

#include "common/base/progress.h"
#include "common/base/scratch_space.h"
#include "common/base/status.h"
#include "common/mesh/triangle_mesh.h"
#include "server/prepare/cell_pieces.h"
#include "server/prepare/preparation_need.h"
#include "server/prepare/prepared_mesh.h"

namespace burnish {

/// The task of a preparation, and what it may use.
struct PrepareOptions {
  int depth = 0;                        ///< 0: default_depth(), or above it if the budget refuses
  double curvature_radius = 0;          ///< averaging radius for κ as a part of L; 0 for none
  int threads = 0;                      ///< 0: all cores
  PreparationBudget* budget = nullptr;  ///< null: the machine's memory
  ScratchSpace space;                   ///< of all large arrays, the prepared ones too
  bool copies_mesh = false;             ///< the scan is in memory once more
  uint64_t pieces_per_brick = PieceRoom::kPiecesPerBrick;  ///< changes no bit
};

/// Runs the whole pipeline: grid, curvature, clipping, integrals, evaluation, histogram. Source:
/// section 5.1. The prepared mesh points to the mesh's arrays and keeps `owner`, which owns them.
/// Needs: a valid mesh (validate()). Asks the budget before it takes memory, and again
/// when it has counted more. Fails: invalid_argument (depth or radius outside its limits; no
/// triangle with area); resource_exhausted that names depth, bytes and limit, and the deepest depth
/// that fits; cancelled. Deterministic: the same bits for any number of threads.
Result<std::shared_ptr<const PreparedMesh>> prepare(const MeshView& mesh,
                                                    std::shared_ptr<const void> owner,
                                                    const PrepareOptions& options,
                                                    const Progress& progress = {},
                                                    PrepareReport* report = nullptr);

/// Does the same over a copy of the mesh.
Result<std::shared_ptr<const PreparedMesh>> prepare(const TriangleMesh& mesh,
                                                    const PrepareOptions& options,
                                                    const Progress& progress = {},
                                                    PrepareReport* report = nullptr);

}  // namespace burnish
