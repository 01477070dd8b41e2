#include <algorithm>
#include <cmath>

#include "client/model/document.h"
#include "client/tools/colours.h"

namespace burnish {

Status Document::update(Renderer& renderer) {
  const LiveNews news = live_->take();
  link_ = news.link;
  stats_ = news.stats;
  unacknowledged_ = news.unacknowledged;
  picture_changes_ += news.displacement.has_value();
  if (news.displacement) RETURN_IF_ERROR(take_displacement(*news.displacement, renderer));
  for (const LiveEvent& event : news.events) handle(event);
  follow_server();
  if (tint_changed_.count > 0 || cell_values_changed_) ++picture_changes_;
  if (tint_changed_.count > 0)
    RETURN_IF_ERROR(renderer.upload_cell_tint(tint_.weights(), std::exchange(tint_changed_, {})));
  if (std::exchange(cell_values_changed_, false))
    RETURN_IF_ERROR(renderer.upload_cell_values(cell_values_));
  return Status::ok();
}

// Uploads the changed corners. A tile's values are in the order of corners, so a tile changes one
// short range of them.
Status Document::take_displacement(const Displacement& displacement, Renderer& renderer) {
  const FrameLayout& layout = *displacement.layout;
  std::vector<IndexRange> changed;
  for (int tile : displacement.changed_tiles) {
    write_displacement(layout, displacement.state, tile, displacements_);
    const auto first = layout.source.begin() + layout.tile_begin(tile);
    const auto [low, high] = std::minmax_element(first, first + layout.tile_size(tile));
    changed.push_back({static_cast<size_t>(*low), static_cast<size_t>(*high - *low) + 1});
  }
  return renderer.upload_displacements(displacements_, changed);
}

namespace {

template <typename... Handlers>
struct Overloaded : Handlers... {
  using Handlers::operator()...;
};

}  // namespace

void Document::handle(const LiveEvent& event) {
  std::visit(Overloaded{
                 [&](const LinkChanged& change) {
                   const bool is_new = std::exchange(link_reason_, change.reason) != change.reason;
                   if (change.state == LinkState::kLost && is_new)
                     log_.warning("connection lost: " + change.reason);
                   if (change.state == LinkState::kEnded) {
                     log_.add(Severity::kError, "session ended: " + change.reason);
                     forget_strokes();
                   }
                   if (change.state == LinkState::kLive)
                     log_.info("connected to " + opened_.server);
                 },
                 [&](const Welcome& welcome) {
                   welcome_ = welcome;
                   edits_known_ = std::max(edits_known_, welcome.session.edits);
                   refresh_history();
                 },
                 [&](const EditsAcknowledged& acknowledged) {
                   edits_known_ = std::max(edits_known_, acknowledged.outcome.edits);
                   refresh_history();
                 },
                 [&](const EditsRefused& refused) {
                   log_.failure("edit refused", refused.status);
                   forget_strokes();
                 },
                 [&](const EditsShown& shown) {
                   shown_after_ms_ = shown.latency_ms;
                   for (const std::string& id : shown.edit_ids) std::erase(tinted_, id);
                   if (tinted_.empty() && !brush_.is_drawing())
                     tint_changed_ = united(tint_changed_, tint_.clear());
                   refresh_cells();
                 },
                 [&](const PreviewShown& shown) { shown_after_ms_ = shown.latency_ms; },
                 [&](const SessionPeople& people) { people_ = people; },
                 [&](const HistoryState& history) {
                   told_ = history;
                   is_told_taken_ = false;
                   edits_known_ = std::max(edits_known_, history.edits);
                   refresh_history();
                   refresh_cells();
                 },
                 [&](const ProgressReport& progress) { progress_ = progress; },
             },
             event);
}

// Takes the slider and the curve from the server after an edit or an undo. A value that the user is
// dragging stays. The server's news of an edit may come after the answer to the next edit.
void Document::follow_server() {
  const bool is_mine_newer = !gesture_.empty() || unacknowledged_ > 0;
  if (is_told_taken_ || is_mine_newer || told_.edits < edits_known_) return;
  is_told_taken_ = true;
  beta_ = told_.gradient_scale;
  if (!(curve_.curve() == told_.transfer_curve)) curve_.set_curve(told_.transfer_curve);
}

void Document::refresh_history() {
  if (history_fetch_->running) {
    history_fetch_->again = true;
    return;
  }
  history_fetch_->running = true;
  tasks_.start([this, alive = std::weak_ptr(alive_), connection = opened_.connection,
                session = opened_.session.id, wake = wake_](std::stop_token) -> Tasks::Completion {
    connection->bring_back();
    auto history = connection->history(session);
    wake();
    return [this, alive, history = std::move(history)] {
      if (alive.expired()) return;
      history_fetch_->running = false;
      if (history.is_ok()) history_ = *history;
      if (std::exchange(history_fetch_->again, false)) refresh_history();
    };
  });
}

void Document::set_colour(ColourBy colour) {
  colour_ = colour;
  if (colour == ColourBy::kCurvature && curvature_.empty()) return fetch_curvature();
  if (colour == ColourBy::kCurvature) {
    cell_values_ = curvature_;
    cell_values_changed_ = true;
  }
  refresh_cells();
}

void Document::refresh_cells() {
  if (colour_ != ColourBy::kBeta) return;
  if (cells_fetch_->running) {
    cells_fetch_->again = true;
    return;
  }
  cells_fetch_->running = true;
  tasks_.start([this, alive = std::weak_ptr(alive_), connection = opened_.connection,
                session = opened_.session.id, wake = wake_](std::stop_token) -> Tasks::Completion {
    connection->bring_back();
    auto cells = connection->cells(session, CellValue::kBeta);
    if (cells.is_ok())
      for (float& value : *cells) value = signed_part_of_beta(value);
    wake();
    return [this, alive, cells = std::move(cells)] {
      if (alive.expired()) return;
      cells_fetch_->running = false;
      if (!cells.is_ok()) log_.failure("gradient scale of the cells", cells.status());
      if (cells.is_ok() && colour_ == ColourBy::kBeta) {
        cell_values_ = *cells;
        cell_values_changed_ = true;
      }
      if (std::exchange(cells_fetch_->again, false)) refresh_cells();
    };
  });
}

void Document::fetch_curvature() {
  tasks_.start([this, alive = std::weak_ptr(alive_), connection = opened_.connection,
                session = opened_.session.id, range = curve_.kappa_range(),
                wake = wake_](std::stop_token) -> Tasks::Completion {
    connection->bring_back();
    auto stronger = connection->cells(session, CellValue::kKappa1);
    const auto other = connection->cells(session, CellValue::kKappa2);
    const Status status = stronger.is_ok() ? other.status() : stronger.status();
    if (status.is_ok())
      for (size_t c = 0; c < stronger->size(); ++c) {
        float& kappa = (*stronger)[c];
        if (std::abs((*other)[c]) > std::abs(kappa)) kappa = (*other)[c];
        kappa = signed_part_of_kappa(kappa, range);
      }
    wake();
    return [this, alive, status, stronger = std::move(stronger)] {
      if (alive.expired()) return;
      if (!status.is_ok()) return log_.failure("curvature of the cells", status);
      curvature_ = *stronger;
      if (colour_ == ColourBy::kCurvature) set_colour(colour_);
    };
  });
}

}  // namespace burnish
