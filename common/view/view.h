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

/// What a client needs to draw a prepared scan and to evaluate its frames: the mesh, or a proxy of
/// it, where its vertices lie in the grid, and the grid. From its grid and points both ends make
/// the same FrameLayout.
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

/// A prepared mesh, as far as views need it. Nothing is copied.
struct ViewSource {
  GridFrame frame;
  double length_unit = 1;            ///< file units
  std::span<const MortonKey> cells;  ///< the finest depth, strictly rising
  DetailedMesh mesh;
  std::span<const Rgba8> colours;  ///< empty, or one per vertex
};

/// A view as it travels.
struct PackedView {
  std::vector<uint8_t> bytes;  ///< in the format of view_format.h
  uint64_t vertices = 0;
  uint64_t triangles = 0;
  uint64_t scan_vertices = 0;  ///< of the whole scan
  uint64_t scan_triangles = 0;
};

/// The view of the scan where triangles_max is 0 or the scan has no more, else of a proxy. The same
/// input gives the same bytes.
/// Cost: a second for some three million triangles, and what make_proxy() costs.
PackedView make_view(const ViewSource& scan, uint64_t triangles_max);

/// What a view may take once it is read.
inline constexpr uint64_t kViewMemoryBytesMax = uint64_t{16} << 30;

/// Any bytes are safe. Fails: data_loss naming what is wrong; unimplemented (another version);
/// resource_exhausted with both numbers when the view would take more than `memory_bytes_max`.
Result<View> read_view(std::span<const uint8_t> bytes,
                       uint64_t memory_bytes_max = kViewMemoryBytesMax);

}  // namespace burnish
