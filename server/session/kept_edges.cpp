#include "server/session/kept_edges.h"

#include <algorithm>

#include "common/base/parallel.h"

namespace burnish {

KeptEdges::KeptEdges(std::shared_ptr<const PreparedMesh> prepared, const SparseGrid& grid,
                     int threads)
    : prepared_(std::move(prepared)), grid_(grid), threads_(threads) {}

KeptEdges::~KeptEdges() {
  leave_work();
}

bool KeptEdges::is_missing(const EdgeFilter& filter) const {
  return !parts_ || !has_same_normals(filter, parts_->filter) ||
         filter.crispness != parts_->filter.crispness;
}

Status KeptEdges::want(const Fields& fields, const Progress& progress) {
  const EdgeFilter& filter = fields.settings().edges;
  if (filter.is_on() && is_missing(filter)) {
    RETURN_IF_ERROR(wait_for_work(filter, progress));
    if (is_missing(filter)) {
      ASSIGN_OR_RETURN(parts_, make_edge_parts(*prepared_, filter, parts_, progress));
    }
  }
  leave_work();
  set(filter, fields.hold());
  return Status::ok();
}

Status KeptEdges::show(const Fields& fields, const EdgeFilter& edited) {
  if (has_made()) RETURN_IF_ERROR(take_made());
  const EdgeFilter& shown = fields.settings().edges;
  const EdgeFilter& filter = parts_ && has_same_normals(shown, parts_->filter) ? shown : edited;
  if (filter.is_on() && is_missing(filter))
    begin(filter);
  else
    leave_work();
  set(filter, fields.hold());
  return Status::ok();
}

bool KeptEdges::is_made_within(std::chrono::milliseconds time) const {
  return work_ && work_->made.wait_for(time) == std::future_status::ready;
}

// Work that is half done comes sooner than new work.
Status KeptEdges::wait_for_work(const EdgeFilter& filter, const Progress& progress) {
  static constexpr auto kLook = std::chrono::milliseconds(20);
  if (!work_ || !has_same_normals(work_->filter, filter)) return Status::ok();
  while (!is_made_within(kLook))
    if (!report(progress, "normals", 0)) return cancelled("keeping edges was cancelled");
  return take_made();
}

Status KeptEdges::take_made() {
  Made made = work_->made.get();
  work_.reset();
  RETURN_IF_ERROR(made.status());
  parts_ = std::move(made).value();
  return Status::ok();
}

// Another crispness waits for the normals: a drag of it must not begin them again and again.
void KeptEdges::begin(const EdgeFilter& filter) {
  if (work_ && has_same_normals(work_->filter, filter)) return;
  leave_work();
  const auto is_left = std::make_shared<std::atomic<bool>>(false);
  const auto make = [prepared = prepared_, before = parts_, threads = threads_, filter, is_left] {
    use_threads(threads);
    return make_edge_parts(*prepared, filter, before,
                           [&](std::string_view, double) { return !*is_left; });
  };
  work_.emplace(Work{filter, is_left, std::async(std::launch::async, make)});
}

void KeptEdges::leave_work() {
  if (work_) *work_->is_left = true;
  work_.reset();  // waits for its end
}

void KeptEdges::set(const EdgeFilter& filter, const std::shared_ptr<const Hold>& held) {
  filter_ = filter;
  if (is_on() && (held != hold_ || parts_ != held_parts_)) hold(held);
}

static TargetGradient times(float factor, TargetGradient of) {
  for (float& entry : of.of_scale) entry *= factor;
  for (float& entry : of.of_target) entry *= factor;
  return of;
}

// A held cell keeps its own gradient.
void KeptEdges::hold(const std::shared_ptr<const Hold>& hold) {
  hold_ = hold;
  held_parts_ = parts_;
  ++version_;
  cells_.clear();
  free_.clear();
  if (!hold || hold->weight.empty()) return;
  cells_ = parts_->target;
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
  free_.assign(prepared_->vertices.size(), 1);
#pragma omp parallel for schedule(static)
  for (size_t v = 0; v < free_.size(); ++v) {
    const EvaluationPoint& point = prepared_->evaluation[v];
    if (point.cell == kNone) continue;
    const auto weights = trilinear_weights(point.local);
    free_[v] = 0;
    for (int a = 0; a < kCornersPerCell; ++a)
      free_[v] += weights[a] * corners[grid_.cell_corners[point.cell][a]];
  }
}

TargetView KeptEdges::target() const {
  if (!is_on()) return {};
  return {cells_.empty() ? parts_->target : cells_, filter_.strength, version_};
}

// Drops the layer of places around triangles that have turned. Returns whether there were any.
bool KeptEdges::stop_turned(std::span<const Vec3d> positions, std::vector<float>& part) const {
  const WeldedSurface& welded = parts_->surface->welded;
  const std::vector<Vec3f>& layer = parts_->filtered->layer;
  const auto at = [&](uint32_t v) -> Vec3d {
    return positions[v] + part[v] * layer[v].cast<double>();
  };
  bool any = false;
  for (size_t t = 0; t < welded.triangle_count(); ++t) {
    if (!welded.is_surface(t)) continue;
    const auto& [a, b, c] = prepared_->triangles[t];
    const auto& before = prepared_->vertices;
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

// Returns the part of each vertex's layer that is not held.
std::vector<float> KeptEdges::free_shares() const {
  std::vector<float> part(prepared_->vertices.size(), static_cast<float>(layer_share()));
  for (size_t v = 0; v < free_.size(); ++v) part[v] *= free_[v];
  return part;
}

std::vector<float> KeptEdges::shares(std::span<const Vec3d> positions) const {
  constexpr int kRounds = 8;
  std::vector<float> part = free_shares();
  for (int round = 0; round < kRounds && stop_turned(positions, part); ++round) {
  }
  return part;
}

void KeptEdges::add_layer(std::span<Vec3d> positions) const {
  if (!is_on()) return;
  const std::vector<float> part = shares(positions);
  for (size_t v = 0; v < positions.size(); ++v)
    positions[v] += double{part[v]} * parts_->filtered->layer[v].cast<double>();
}

std::vector<Vec3f> KeptEdges::layer(std::span<const Vec3d> positions) const {
  const std::vector<float> part = positions.empty() ? free_shares() : shares(positions);
  std::vector<Vec3f> moves(part.size());
#pragma omp parallel for schedule(static)
  for (size_t v = 0; v < moves.size(); ++v) moves[v] = part[v] * parts_->filtered->layer[v];
  return moves;
}

uint64_t KeptEdges::byte_count() const {
  return (parts_ ? parts_->byte_count() : 0) + cells_.size() * sizeof(TargetGradient) +
         free_.size() * sizeof(float);
}

}  // namespace burnish
