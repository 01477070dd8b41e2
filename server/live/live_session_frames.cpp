// The part of a live session for the frames of its clients.

#include <utility>

#include "server/live/live_session.h"

namespace burnish {

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
  for (const auto& [connection, seat] : seats_)
    if (seat.subscriber->wants_frame(version, settled))
      wishes.push_back({seat, seat.subscriber->pages()});
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
      std::make_shared<const SurfaceShot>(SurfaceShot::unmoved(pages_of_wishes(wanting)));
  for (Wish& wish : wanting)
    wish.seat.subscriber->show(
        {.surface = surface, .pages = std::move(wish.pages), .is_still = true, .stats = {}});
}

void LiveSession::begin_steady_surface(SessionTurn& at) {
  const PreparedMesh& prepared = at.session().prepared();
  const Hierarchy& hierarchy = at.hierarchy();
  const SparseGrid& grid = hierarchy.at(hierarchy.finest).grid;
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

Status LiveSession::send_frames(SessionTurn& at) {
  Session& session = at.session();
  FrameStats stats = stats_of(at);
  std::vector<Wish> wanting = wishes(version_, stats.settled);
  if (wanting.empty()) return Status::ok();
  // While a client gets more and more pages of a still surface, the others are not done again.
  if (still_ && (!stats.settled || still_->version != version_)) still_.reset();
  const Hierarchy& hierarchy = at.hierarchy();
  const SurfaceMoment moment{.grid = hierarchy.at(hierarchy.finest).grid,
                             .scan = session.prepared().evaluation,
                             .displacement = shown_displacement(at, stats),
                             .beta = session.shown_fields().view().beta,
                             .settled = stats.settled,
                             .last = still_ ? still_->shot.get() : nullptr,
                             .colour = session.colour_change(),
                             .held = held_points(session)};
  stats.volume = session.kept_volume().value_or(0);
  ASSIGN_OR_RETURN(SurfaceShot taken, SurfaceShot::take(moment, pages_of_wishes(wanting)));
  const auto surface = std::make_shared<const SurfaceShot>(std::move(taken));
  if (stats.settled) still_ = {version_, surface};
  for (Wish& wish : wanting) {
    stats.previews = wish.seat.previews_taken;
    wish.seat.subscriber->show({surface, std::move(wish.pages), version_, stats.settled, stats});
  }
  return Status::ok();
}

}  // namespace burnish
