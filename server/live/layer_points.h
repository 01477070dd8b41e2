#pragma once

#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <span>
#include <vector>

#include "server/live/live_page.h"

namespace burnish {

/// Finds the scan's vertices that the vertices of pages are, because a layer moves vertices. A
/// vertex of a coarse page that the scan does not have moves as the nearest one near its cell.
/// Not thread-safe.
class LayerPoints {
 public:
  static constexpr uint32_t kNoVertex = std::numeric_limits<uint32_t>::max();
  /// One vertex of the scan per vertex of a page, or kNoVertex.
  using OfPage = std::shared_ptr<const std::vector<uint32_t>>;

  /// Shapes: one point per vertex of the scan. Needs: both outlive this.
  LayerPoints(const SparseGrid& grid, std::span<const EvaluationPoint> scan);

  /// Finds them once for each page, as long as somebody shows it. Needs: a page of the scan, of
  /// kind kVertices, in this grid.
  OfPage of(const std::shared_ptr<const LivePage>& page);

 private:
  struct Found {
    std::weak_ptr<const LivePage> page;
    OfPage of_scan;
  };
  /// The nearest vertex so far. Units: cells.
  struct Nearest {
    uint32_t vertex = kNoVertex;
    float distance = std::numeric_limits<float>::infinity();  // squared
  };
  OfPage find(const LivePage& page) const;
  uint32_t find(const EvaluationPoint& point, float half_step) const;
  void look_in(int32_t cell, const Vec3f& place, Nearest& nearest) const;
  Vec3f place_of(const EvaluationPoint& point, int32_t seen_from) const;

  const SparseGrid& grid_;
  const std::span<const EvaluationPoint> scan_;
  std::vector<uint32_t> first_;     // per cell and one past the last, into vertices_
  std::vector<uint32_t> vertices_;  // of the scan, by their cells
  std::map<const LivePage*, Found> found_;
};

}  // namespace burnish
