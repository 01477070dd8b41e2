#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "common/base/progress.h"
#include "common/base/status.h"
#include "common/denoise/denoise.h"
#include "common/grid/sparse_grid.h"
#include "server/fields/fields.h"

namespace burnish {

/// What keeps edges while a surface is denoised: filtered normals, the layer of moves towards them,
/// and the gradients that the solver should reach. Costs nothing before edges are first kept.
class KeptEdges {
 public:
  /// Needs: both outlive this.
  KeptEdges(const PreparedMesh& prepared, const SparseGrid& grid)
      : prepared_(prepared), grid_(grid) {}

  /// Makes what is missing for the fields' filter and for what is held. A filter of another kind,
  /// angle or number of passes filters the normals anew; another crispness fits gradients; another
  /// strength costs nothing. Fails: cancelled; resource_exhausted; then edges are not kept.
  Status want(const Fields& fields, const Progress& progress = {});

  bool is_on() const { return filter_.is_on() && !fitted_.empty(); }

  /// Returns the solver's part. Valid until the next want().
  TargetView target() const;

  /// Adds the layer to the vertices, except around triangles that would turn by more than 90
  /// degrees against the scan's with it. Shapes: one per vertex, file units.
  void add_layer(std::span<Vec3d> positions) const;

  uint64_t byte_count() const {
    return (normals_.size() + layer_.size()) * sizeof(Vec3f) +
           (fitted_.size() + cells_.size()) * sizeof(TargetGradient) +
           free_.size() * sizeof(float) +
           (surface_ ? kSurfaceBytesPerTriangle * prepared_.triangles.size() : 0);
  }

 private:
  Status make(const Fields& fields, const Progress& progress);
  Status filter_normals(const EdgeFilter& filter, const Progress& progress);
  Status fit(const EdgeFilter& filter, const Progress& progress);
  void hold(const std::shared_ptr<const Hold>& hold);
  void give_up();
  void free_vertices(const Hold& hold);
  bool stop_turned(std::span<const Vec3d> positions, std::vector<float>& part) const;

  static constexpr uint64_t kSurfaceBytesPerTriangle = 90;

  const PreparedMesh& prepared_;
  const SparseGrid& grid_;
  std::shared_ptr<const DenoiseSurface> surface_;
  EdgeFilter filter_;                   // of all below; off before the first
  std::vector<Vec3f> normals_;          // one per triangle
  std::vector<Vec3f> layer_;            // one per vertex, at crispness 1; file units
  std::vector<TargetGradient> fitted_;  // one per cell
  std::vector<TargetGradient> cells_;   // likewise, less where cells are held; empty: none is
  std::vector<float> free_;             // one per vertex: 0 where it is held; empty: all are free
  std::shared_ptr<const Hold> hold_;
  uint64_t version_ = 0;
};

}  // namespace burnish
