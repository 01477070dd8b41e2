#include "server/session/kept_edges.h"

#include <algorithm>
#include <utility>

#include "common/base/parallel.h"

namespace burnish {

KeptEdges::KeptEdges(std::shared_ptr<const PreparedMesh> prepared, const SparseGrid& grid,
                     BackendKind backend, int threads)
    : prepared_(std::move(prepared)),
      backend_(backend),
      threads_(threads),
      strength_(*prepared_, grid) {}

KeptEdges::~KeptEdges() {
  leave_work();
}

bool KeptEdges::is_missing(const EdgeFilter& filter) const {
  return !parts_ || !has_same_normals(filter, parts_->filter) ||
         filter.crispness != parts_->filter.crispness;
}

Status KeptEdges::want(const Fields& fields, const Progress& progress) {
  const EdgeFilter& filter = fields.settings().edges;
  if (fields.keeps_edges() && is_missing(filter)) {
    RETURN_IF_ERROR(wait_for_work(filter, progress));
    if (is_missing(filter)) {
      ASSIGN_OR_RETURN(parts_, make_edge_parts(*prepared_, backend_, filter, parts_, progress));
      ++version_;
    }
  }
  leave_work();
  set(fields, filter.strength);
  return Status::ok();
}

// The memory of a filter is promised to edits, not to previews: these show what there is.
Status KeptEdges::show(const Fields& fields, const Fields& edited) {
  if (has_made()) RETURN_IF_ERROR(take_made());
  const EdgeFilter& shown = fields.settings().edges;
  const bool is_shown = parts_ && has_same_normals(shown, parts_->filter);
  const EdgeFilter& filter = is_shown ? shown : edited.settings().edges;
  if ((is_shown ? fields : edited).keeps_edges() && is_missing(filter))
    begin(filter);
  else
    leave_work();
  set(fields, filter.strength);
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
  ++version_;
  return Status::ok();
}

// Another crispness waits for the normals: a drag of it must not begin them again and again.
void KeptEdges::begin(const EdgeFilter& filter) {
  if (work_ && has_same_normals(work_->filter, filter)) return;
  leave_work();
  const auto is_left = std::make_shared<std::atomic<bool>>(false);
  const auto make = [prepared = prepared_, backend = backend_, before = parts_, threads = threads_,
                     filter, is_left] {
    use_threads(threads);
    return make_edge_parts(*prepared, backend, filter, before,
                           [&](std::string_view, double) { return !*is_left; });
  };
  work_.emplace(Work{filter, is_left, std::async(std::launch::async, make)});
}

void KeptEdges::leave_work() {
  if (work_) *work_->is_left = true;
  work_.reset();  // waits for its end
}

void KeptEdges::set(const Fields& fields, double strength) {
  is_wanted_ = fields.keeps_edges();
  if (is_on()) strength_.take(fields, strength);
}

TargetView KeptEdges::target() const {
  if (!is_on()) return {};
  return {parts_->target, strength_.most(), version_, strength_.in_cells(), strength_.version()};
}

std::vector<uint8_t> KeptEdges::find_turned(std::span<const Vec3d> positions,
                                            std::span<const float> shares) const {
  const WeldedSurface& welded = parts_->surface->welded;
  const std::vector<Vec3f>& layer = parts_->filtered->layer;
  const std::span<const Vec3d> before = prepared_->vertices;
  const auto at = [&](uint32_t v) -> Vec3d {
    return positions[v] + shares[v] * layer[v].cast<double>();
  };
  std::vector<uint8_t> is_turned(welded.triangle_count(), 0);
#pragma omp parallel for schedule(static)
  for (size_t t = 0; t < is_turned.size(); ++t) {
    if (!welded.is_surface(t)) continue;
    const auto& [a, b, c] = prepared_->triangles[t];
    const Vec3d was = (before[b] - before[a]).cross(before[c] - before[a]);
    is_turned[t] = was.dot((at(b) - at(a)).cross(at(c) - at(a))) < 0;
  }
  return is_turned;
}

// Drops the layer of places around triangles that have turned. Returns whether there were any.
bool KeptEdges::stop_turned(std::span<const Vec3d> positions, std::vector<float>& shares) const {
  const WeldedSurface& welded = parts_->surface->welded;
  const std::vector<uint8_t> is_turned = find_turned(positions, shares);
  bool any = false;
  for (size_t t = 0; t < is_turned.size(); ++t) {
    if (!is_turned[t]) continue;
    for (const uint32_t place : welded.triangle(t)) any |= std::exchange(shares[place], 0.0f) != 0;
  }
  if (!any) return false;
#pragma omp parallel for schedule(static)
  for (size_t v = 0; v < shares.size(); ++v)
    if (const uint32_t place = welded.place(v); place != v) shares[v] = shares[place];
  return true;
}

std::vector<float> KeptEdges::layer_shares() const {
  std::vector<float> shares(prepared_->vertices.size(), static_cast<float>(layer_share()));
  const std::span<const float> parts = strength_.at_vertices();
#pragma omp parallel for schedule(static)
  for (size_t v = 0; v < parts.size(); ++v) shares[v] *= parts[v];
  return shares;
}

std::vector<float> KeptEdges::layer_shares(std::span<const Vec3d> positions) const {
  constexpr int kRounds = 8;
  std::vector<float> shares = layer_shares();
  for (int round = 0; round < kRounds && stop_turned(positions, shares); ++round) {
  }
  return shares;
}

void KeptEdges::add_layer(std::span<Vec3d> positions) const {
  if (!is_on()) return;
  const std::vector<float> shares = layer_shares(positions);
#pragma omp parallel for schedule(static)
  for (size_t v = 0; v < positions.size(); ++v)
    positions[v] += double{shares[v]} * parts_->filtered->layer[v].cast<double>();
}

std::vector<Vec3f> KeptEdges::layer(std::span<const Vec3d> positions, double scale) const {
  const std::vector<float> shares = positions.empty() ? layer_shares() : layer_shares(positions);
  std::vector<Vec3f> moves(shares.size());
#pragma omp parallel for schedule(static)
  for (size_t v = 0; v < moves.size(); ++v)
    moves[v] = static_cast<float>(scale) * shares[v] * parts_->filtered->layer[v];
  return moves;
}

uint64_t KeptEdges::byte_count() const {
  return (parts_ ? parts_->byte_count() : 0) + strength_.byte_count();
}

}  // namespace burnish
