// The part of a live session for the frames of its clients.

#include <utility>

#include "server/live/live_session.h"

namespace burnish {

static const SparseGrid& finest_grid(const SessionTurn& at) {
  return at.hierarchy().at(at.hierarchy().finest).grid;
}

void LiveSession::wake_for_frames() {
  if (is_unmoved_) show_unmoved();
  wake();
}

FrameStats LiveSession::stats_of(SessionTurn& at) const {
  const StepReport& last = at.last();
  return {.settled = at.session().is_settled(last),
          .exact = at.session().is_exact(last),
          .cycles = last.cycle,
          .energy = last.energy,
          .residual = last.residual,
          .distance = last.distance,
          .edits = at.edits(),
          .assemble_ms = assemble_ms_,
          .solve_ms = solve_ms_};
}

std::vector<LiveSession::Wish> LiveSession::wishes(uint64_t version, bool settled) const {
  const std::lock_guard lock(mutex_);
  std::vector<Wish> wishes;
  for (const auto& [connection, slot] : slots_)
    if (slot.subscriber->wants_frame(version, settled))
      wishes.push_back({slot, slot.subscriber->pages()});
  return wishes;
}

template <typename Wishes>
static std::vector<std::shared_ptr<const ClientPages>> pages_of_wishes(const Wishes& wishes) {
  std::vector<std::shared_ptr<const ClientPages>> pages;
  for (const auto& wish : wishes) pages.push_back(wish.pages);
  return pages;
}

// Its figures say that it shows no edit and has not settled.
void LiveSession::show_unmoved() {
  std::vector<Wish> wanting = wishes(0, false);
  if (wanting.empty()) return;
  const auto surface =
      std::make_shared<const SurfaceSnapshot>(SurfaceSnapshot::unmoved(pages_of_wishes(wanting)));
  for (Wish& wish : wanting)
    wish.slot.subscriber->show(
        {.surface = surface, .pages = std::move(wish.pages), .is_still = true, .stats = {}});
}

void LiveSession::begin_steady_surface(SessionTurn& at) {
  const PreparedMesh& prepared = at.session().prepared();
  const SparseGrid& grid = finest_grid(at);
  auto memory = manager_.memory().take(kServer, SteadySurface::byte_count(grid));
  if (!memory.is_ok()) return;  // frames are larger without
  const double distance =
      kSteadyDistance * prepared.statistics.diagonal() / prepared.frame.cell_size;
  steady_.emplace(grid, prepared.evaluation, static_cast<float>(distance),
                  std::move(memory).value());
}

// Until it has settled once, all of the surface moves, and nothing stays behind.
std::span<const Vec3f> LiveSession::shown_displacement(SessionTurn& at, FrameStats& stats) {
  const std::span<const Vec3f> now = at.session().displacement();
  if (!steady_ && stats.settled) begin_steady_surface(at);
  if (!steady_) return now;
  std::span<const Vec3f> shown = steady_->shown();
  if (!still_ || shown.empty()) shown = stats.exact ? steady_->show_all(now) : steady_->show(now);
  if (stats.settled) steady_->rest();
  if (steady_->is_behind()) stats.distance += kSteadyDistance;
  return shown;
}

HeldPoints* LiveSession::held_points(const Session& session) {
  const auto& rims = session.shown_fields().rims();
  if (!rims)
    held_.reset();
  else if (!held_ || held_->rims() != rims)
    held_.emplace(session.prepared(), rims);
  return held_ ? &*held_ : nullptr;
}

LayerPoints* LiveSession::layer_points(SessionTurn& at, const VertexLayer& layer) {
  if (!layer.moves.empty() && !layer_points_)
    layer_points_.emplace(finest_grid(at), at.session().prepared().evaluation);
  return layer_points_ ? &*layer_points_ : nullptr;
}

// A page of corners that does not stay one is made anew, and comes then.
static bool waits_for_pages(const ClientPages& pages, bool has_layer) {
  return has_layer && pages.kind == PageFrameKind::kCorners && !pages.insists;
}

Status LiveSession::send_frames(SessionTurn& at) {
  Session& session = at.session();
  FrameStats stats = stats_of(at);
  const bool has_layer = session.has_layer();
  for (const auto& subscriber : subscribers()) subscriber->set_layer(has_layer);
  std::vector<Wish> wanting = wishes(version_, stats.settled);
  std::erase_if(wanting, [&](const Wish& wish) { return waits_for_pages(*wish.pages, has_layer); });
  if (wanting.empty()) return Status::ok();
  // While a client gets more and more pages of a still surface, the others are not done again.
  if (still_ && (!stats.settled || still_->version != version_)) still_.reset();
  const std::span<const Vec3f> displacement = shown_displacement(at, stats);
  const VertexLayer layer = session.layer(displacement);
  const SurfaceMoment moment{.grid = finest_grid(at),
                             .scan = session.prepared().evaluation,
                             .displacement = displacement,
                             .beta = session.shown_fields().view().beta,
                             .settled = stats.settled,
                             .last = still_ ? still_->snapshot.get() : nullptr,
                             .colour = session.colour_change(),
                             .held = held_points(session),
                             .layer = layer,
                             .layer_points = layer_points(at, layer)};
  stats.volume = session.kept_volume().value_or(0);
  ASSIGN_OR_RETURN(SurfaceSnapshot taken, SurfaceSnapshot::take(moment, pages_of_wishes(wanting)));
  const auto surface = std::make_shared<const SurfaceSnapshot>(std::move(taken));
  if (stats.settled) still_ = {version_, surface};
  for (Wish& wish : wanting) {
    FrameStats told = stats;
    told.previews = wish.slot.previews_taken;
    told.exact &= !has_layer || wish.pages->kind == PageFrameKind::kVertices;
    wish.slot.subscriber->show({surface, std::move(wish.pages), version_, stats.settled, told});
  }
  return Status::ok();
}

}  // namespace burnish
