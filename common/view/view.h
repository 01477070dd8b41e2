#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/base/status.h"
#include "common/evaluation/evaluation.h"
#include "common/evaluation/proxy.h"
#include "common/grid/grid.h"
#include "common/grid/sparse_grid.h"
#include "common/mesh/triangle_mesh.h"

namespace burnish {

/// Everything that a client needs to draw a prepared scan and to evaluate its frames: the mesh or a
/// proxy of it, the places of its vertices in the grid, and the grid. Both ends make the same
/// FrameLayout from the grid and the points.
struct View {
  GridFrame frame;
  double length_unit = 1;               ///< L = sqrt(area), file units
  SparseGrid grid;                      ///< the finest depth
  std::vector<Vec3d> vertices;          ///< file units, within 1e-6 cell of the scan's
  std::vector<Triangle> triangles;      ///< indices into `vertices`
  std::vector<EvaluationPoint> points;  ///< one per vertex
  std::vector<Rgba8> colours;           ///< empty, or one per vertex
  uint64_t scan_vertices = 0;           ///< of the whole scan
  uint64_t scan_triangles = 0;

  bool is_proxy() const { return triangles.size() < scan_triangles; }
};

/// The parts of a prepared mesh that views need. Nothing is copied.
struct ViewSource {
  GridFrame frame;
  double length_unit = 1;            ///< file units
  std::span<const MortonKey> cells;  ///< the finest depth, strictly rising
  DetailedMesh mesh;
  std::span<const Rgba8> colours;  ///< empty, or one per vertex
};

/// A view in the form that travels.
struct PackedView {
  std::vector<uint8_t> bytes;  ///< in the format of view_format.h
  uint64_t vertices = 0;
  uint64_t triangles = 0;
  uint64_t scan_vertices = 0;  ///< of the whole scan
  uint64_t scan_triangles = 0;
};

/// Makes the view of the whole scan if triangles_max is 0 or the scan has no more triangles, else
/// the view of a proxy. The same input gives the same bytes.
/// Cost: about a second per three million triangles, plus make_proxy().
PackedView make_view(const ViewSource& scan, uint64_t triangles_max);

/// Limit of the memory that a view takes once it is read.
inline constexpr uint64_t kViewMemoryBytesMax = uint64_t{16} << 30;

/// Safe for any bytes. Fails: data_loss that names the damage; unimplemented (another version);
/// resource_exhausted with both numbers when the view would take more than `memory_bytes_max`.
Result<View> read_view(std::span<const uint8_t> bytes,
                       uint64_t memory_bytes_max = kViewMemoryBytesMax);

}  // namespace burnish
