#pragma once

#include <string>

#include "common/edit/edge_filter.h"
#include "common/mesh/triangle_mesh.h"
#include "tests/bench/report.h"

namespace burnish {

/// A shape, the same with noise, and the preset that keeps its edges.
struct NoisyShape {
  std::string shape, noise;
  TriangleMesh clean, noisy;
  EdgePreset preset;
};

/// Filters a mesh as `burnish filter --keep-edges` does, at the default depth. Fails: as preparing
/// and solving do.
Result<TriangleMesh> with_edges_kept(const TriangleMesh& noisy, const EdgeFilter& filter);

/// Returns what `--keep-edges auto` chooses. Fails: without memory.
Result<EdgeFilter> proposed_filter(const TriangleMesh& noisy);

/// Filters the shape as `burnish filter` does, at the default depth, and adds a row for each way:
/// its errors against the clean shape. Fails: as preparing and solving do.
Status report_filtered(const NoisyShape& shape, BenchTable& table);

/// Does the same with β = 3. Errors are those against the clean shape so sharpened.
Status report_sharpened(const NoisyShape& shape, BenchTable& table);

}  // namespace burnish
