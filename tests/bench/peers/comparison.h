#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "common/base/status.h"
#include "common/mesh/triangle_mesh.h"

namespace burnish::bench {

/// The row of CHOLMOD on the product's own matrix.
inline constexpr std::string_view kGridPeer = "CHOLMOD on our matrix";

struct ComparisonOptions {
  std::vector<int> threads;        ///< a table for each
  std::vector<double> alphas;      ///< a table for each
  std::vector<std::string> peers;  ///< empty for all
  uint64_t bytes_max = 0;          ///< limit of a factor that is tried
};

/// Measures the product and its peers on one scan, prints the tables, returns their rows. Needs: a
/// valid mesh. Fails: as prepare() and Solver::solve() do. A failed peer has rows that say so.
Result<nlohmann::ordered_json> compare(const TriangleMesh& mesh, int depth,
                                       const ComparisonOptions& options);

}  // namespace burnish::bench
