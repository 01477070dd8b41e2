#include "server/session/kept_edges.h"

#include <algorithm>

#include "common/base/out_of_memory.h"
#include "server/fields/target_fit.h"

namespace burnish {

Status KeptEdges::want(const Fields& fields, const Progress& progress) {
  const Status made = with_memory_for("keeping edges", [&] { return make(fields, progress); });
  if (!made.is_ok()) give_up();
  return made;
}

Status KeptEdges::make(const Fields& fields, const Progress& progress) {
  const EdgeFilter& filter = fields.settings().edges;
  if (!filter.is_on()) {
    filter_.strength = 0;
    return Status::ok();
  }
  const bool is_new = normals_.empty() || filter.kind != filter_.kind ||
                      filter.edge_angle != filter_.edge_angle || filter.passes != filter_.passes;
  const bool is_fit_new = is_new || filter.crispness != filter_.crispness;
  if (is_new) RETURN_IF_ERROR(filter_normals(filter, progress));
  if (is_fit_new) RETURN_IF_ERROR(fit(filter, progress));
  if (is_fit_new || fields.hold() != hold_) hold(fields.hold());
  filter_ = filter;
  return Status::ok();
}

void KeptEdges::give_up() {
  filter_ = {};
  normals_ = layer_ = {};
  fitted_ = cells_ = {};
}

Status KeptEdges::filter_normals(const EdgeFilter& filter, const Progress& progress) {
  if (!surface_) {
    MeshView mesh;
    mesh.vertices = prepared_.vertices;
    mesh.triangles = prepared_.triangles;
    ASSIGN_OR_RETURN(surface_, make_denoise_surface(mesh, {}, progress));
  }
  const auto keep_last = [&](int pass, std::span<const NormalAndArea> normals) {
    if (pass < filter.passes) return;
    normals_.resize(normals.size());
    for (size_t t = 0; t < normals.size(); ++t) normals_[t] = normal_of(normals[t]).cast<float>();
  };
  ASSIGN_OR_RETURN(layer_, denoise_layer(*surface_, filter, {}, progress, keep_last));
  return Status::ok();
}

Status KeptEdges::fit(const EdgeFilter& filter, const Progress& progress) {
  ASSIGN_OR_RETURN(fitted_, fit_target(prepared_, {normals_, layer_, filter.crispness}, progress));
  return Status::ok();
}

static TargetGradient times(float factor, TargetGradient of) {
  for (float& entry : of.of_scale) entry *= factor;
  for (float& entry : of.of_target) entry *= factor;
  return of;
}

// A held cell keeps its own gradient.
void KeptEdges::hold(const std::shared_ptr<const Hold>& hold) {
  hold_ = hold;
  ++version_;
  cells_.clear();
  free_.clear();
  if (!hold || hold->weight.empty()) return;
  cells_ = fitted_;
  for (size_t c = 0; c < cells_.size(); ++c) cells_[c] = times(1 - hold->weight[c], cells_[c]);
  free_vertices(*hold);
}

// A corner is as free as the least free of its cells, so a vertex in a held cell has no layer, and
// beside it the layer begins without a step.
void KeptEdges::free_vertices(const Hold& hold) {
  std::vector<float> corners(grid_.corner_count(), 1);
  for (size_t i = 0; i < corners.size(); ++i)
    for (const int32_t cell : grid_.cells_of_corner[i])
      if (cell != kNone) corners[i] = std::min(corners[i], 1 - hold.weight[cell]);
  free_.assign(layer_.size(), 1);
#pragma omp parallel for schedule(static)
  for (size_t v = 0; v < free_.size(); ++v) {
    const EvaluationPoint& point = prepared_.evaluation[v];
    if (point.cell == kNone) continue;
    const auto weights = trilinear_weights(point.local);
    free_[v] = 0;
    for (int a = 0; a < kCornersPerCell; ++a)
      free_[v] += weights[a] * corners[grid_.cell_corners[point.cell][a]];
  }
}

TargetView KeptEdges::target() const {
  if (!is_on()) return {};
  return {cells_.empty() ? fitted_ : cells_, filter_.strength, version_};
}

// Drops the layer of places around triangles that have turned. Returns whether there were any.
bool KeptEdges::stop_turned(std::span<const Vec3d> positions, std::vector<float>& part) const {
  const WeldedSurface& welded = surface_->welded;
  const auto at = [&](uint32_t v) -> Vec3d {
    return positions[v] + part[v] * layer_[v].cast<double>();
  };
  bool any = false;
  for (size_t t = 0; t < welded.triangle_count(); ++t) {
    if (!welded.is_surface(t)) continue;
    const auto& [a, b, c] = prepared_.triangles[t];
    const auto& before = prepared_.vertices;
    const Vec3d was = (before[b] - before[a]).cross(before[c] - before[a]);
    if (!(was.dot((at(b) - at(a)).cross(at(c) - at(a))) < 0)) continue;
    for (const uint32_t place : welded.triangle(t)) {
      any |= part[place] != 0;
      part[place] = 0;
    }
  }
  for (size_t v = 0; any && v < part.size(); ++v) part[v] = part[welded.place(v)];
  return any;
}

void KeptEdges::add_layer(std::span<Vec3d> positions) const {
  if (!is_on()) return;
  constexpr int kRounds = 8;
  const double whole = filter_.strength * filter_.crispness;
  std::vector<float> part(positions.size(), static_cast<float>(whole));
  for (size_t v = 0; v < free_.size(); ++v) part[v] *= free_[v];
  for (int round = 0; round < kRounds && stop_turned(positions, part); ++round) {
  }
  for (size_t v = 0; v < positions.size(); ++v)
    positions[v] += double{part[v]} * layer_[v].cast<double>();
}

}  // namespace burnish
