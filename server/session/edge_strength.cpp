#include "server/session/edge_strength.h"

#include <algorithm>

namespace burnish {

void EdgeStrength::take(const Fields& fields, double strength) {
  const PaintLayer* const paint = fields.edge_paint();
  Sources sources;
  if (fields.hold() && !fields.hold()->weight.empty()) sources.hold = fields.hold();
  if (paint) sources = {sources.hold, true, fields.paint_versions().edges, strength};
  most_ = paint ? 1 : strength;
  if (sources == sources_) return;
  sources_ = std::move(sources);
  ++version_;
  cells_.clear();
  vertices_.clear();
  if (!paint && !sources_.hold) return;
  make_cells(paint);
  make_vertices();
}

// Paint covers what is set for the whole scan; what is held stays whatever is painted.
void EdgeStrength::make_cells(const PaintLayer* paint) {
  cells_.assign(prepared_.cells.size(), 1);
  const auto unpainted = static_cast<float>(sources_.strength);
#pragma omp parallel for schedule(static)
  for (size_t c = 0; c < cells_.size(); ++c) {
    if (paint) cells_[c] = unpainted + paint->weight[c] * (paint->value[c] - unpainted);
    if (sources_.hold) cells_[c] *= 1 - sources_.hold->weight[c];
  }
}

// A corner has the mean of its cells, but of a held cell nothing: so a vertex there does not move,
// and beside it the layer begins without a step.
std::vector<float> EdgeStrength::corners() const {
  std::vector<float> corners(grid_.corner_count());
#pragma omp parallel for schedule(static)
  for (size_t i = 0; i < corners.size(); ++i) {
    float sum = 0, least = 1;
    int count = 0;
    for (const int32_t cell : grid_.cells_of_corner[i]) {
      if (cell == kNone) continue;
      sum += cells_[cell];
      ++count;
      if (sources_.hold) least = std::min(least, 1 - sources_.hold->weight[cell]);
    }
    corners[i] = sources_.is_painted ? least * sum / static_cast<float>(count) : least;
  }
  return corners;
}

void EdgeStrength::make_vertices() {
  const std::vector<float> of_corner = corners();
  vertices_.assign(prepared_.vertices.size(), 0);
#pragma omp parallel for schedule(static)
  for (size_t v = 0; v < vertices_.size(); ++v) {
    const EvaluationPoint& point = prepared_.evaluation[v];
    if (point.cell == kNone) continue;
    const auto weights = trilinear_weights(point.local);
    for (int a = 0; a < kCornersPerCell; ++a)
      vertices_[v] += weights[a] * of_corner[grid_.cell_corners[point.cell][a]];
  }
}

}  // namespace burnish
