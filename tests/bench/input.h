#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "common/mesh/triangle_mesh.h"
#include "server/solver/cycle/multigrid.h"

namespace burnish {

/// A scan of the command line: "SCAN" or "SCAN@DEPTH". SCAN is a mesh file or "KIND:VERTICES" of a
/// generated scan. "KIND:VERTICES:STRETCH" is stretched along z and has fewer corners.
struct ScanArgument {
  std::string scan;
  int depth = 0;  ///< 0: default_depth()

  std::string name() const;  ///< "blob:400000", or the file's name without folder and extension
};

/// Fails: invalid_argument that names a depth outside its limits.
Result<ScanArgument> parse_scan(std::string_view text);

/// Fails: as generate_scan() and read_mesh() say.
Result<TriangleMesh> load_mesh(const ScanArgument& scan);

/// A mesh at one depth, ready for any number of solvers.
struct BenchSystem : Multigrid {
  std::string name;  ///< of the scan, and "@DEPTH"

  int depth() const { return hierarchy->finest; }
  int32_t corners() const { return hierarchy->at(hierarchy->finest).grid.corner_count(); }
};

/// Returns the depth that `scan` asks for on this mesh.
int depth_of(const ScanArgument& scan, const TriangleMesh& mesh);

/// Fails: resource_exhausted, before anything large is made, if it expects more than `corners_max`
/// corners, or the machine has too little free memory for a session on them.
Status check_size(const std::string& name, const TriangleMesh& mesh, int depth, double corners_max);

/// Fails: as check_size() and prepare() say.
Result<BenchSystem> make_system(const ScanArgument& scan, const TriangleMesh& mesh, int depth,
                                double corners_max);

}  // namespace burnish
