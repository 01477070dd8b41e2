#include <algorithm>
#include <cmath>

#include "client/model/document.h"

namespace burnish {

void Document::on_picture(double ms, std::optional<double> surface_ms) {
  live_->on_picture(std::chrono::microseconds(static_cast<int64_t>(1000 * ms)));
  surface_->on_picture(surface_ms.value_or(ms));
}

void Document::update(bool draws) {
  const LiveNews news = live_->take(draws);
  link_ = news.link;
  stats_ = news.stats;
  unacknowledged_ = news.unacknowledged;
  surface_->take(news);
  if (!draws) surface_->take_arrivals();
  for (const LiveEvent& event : news.events) handle(event);
  follow_server();
  take_noise();
}

Status Document::look(const Camera& camera, const ImageSize& size, bool is_unlit) {
  const bool is_dragging = !gesture_.empty() && !brush_.is_drawing();
  surface_->show_scan_colours(colour_ == ColourBy::kScan, is_unlit);
  RETURN_IF_ERROR(surface_->look(camera, size, is_dragging));
  fetch_values();
  fetch_over();
  renew_pages();
  renew_textures();
  const std::string failures = surface_->take_failures();
  if (!failures.empty()) log_.warning(failures);
  return Status::ok();
}

// Describing the pages has the server make what it lacks.
void Document::renew_pages() {
  const std::optional<Status> damage = surface_->take_damage();
  if (!damage || std::exchange(is_renewing_pages_, true)) return;
  log_.warning("the server makes the pages of the scan again: " + damage->message());
  tasks_.start([this, alive = std::weak_ptr(alive_), connection = opened_.connection,
                scan = opened_.session.scan_id](const StopToken& stop) -> Tasks::Completion {
    const auto goes_on = [&](std::string_view, double) { return !stop.stop_requested(); };
    const Status made = connection->describe_pages(scan, goes_on).status();
    return [this, alive, made] {
      if (alive.expired()) return;
      is_renewing_pages_ = false;
      if (!made.is_ok()) return log_.failure("pages", made);
      surface_->on_pages_renewed();
    };
  });
}

namespace {

template <typename... Handlers>
struct Overloaded : Handlers... {
  using Handlers::operator()...;
};
template <typename... Handlers>
Overloaded(Handlers...) -> Overloaded<Handlers...>;  // clang 16 needs to be told

}  // namespace

// The ids of edits say nothing to a user.
static Status without_ids(const EditsRefused& refused) {
  Status status = refused.status;
  for (const std::string& id : refused.edit_ids) status = status.renamed("edit " + id + ": ", "");
  return status;
}

void Document::handle(const LiveEvent& event) {
  std::visit(Overloaded{
                 [&](const LinkChanged& change) {
                   const bool is_new = std::exchange(link_reason_, change.reason) != change.reason;
                   is_moving_ = change.has_moved;
                   if (change.has_moved && is_new) log_.info("the session moves to another server");
                   if (change.state == LinkState::kLost && is_new && !change.has_moved)
                     log_.warning("connection lost: " + change.reason);
                   if (change.state == LinkState::kEnded) {
                     log_.add(Severity::kError, "session ended: " + change.reason);
                     forget_strokes();
                   }
                   if (change.state == LinkState::kLive) {
                     log_.info("connected");
                     surface_->on_link_made();
                     retry_textures();
                   }
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
                   log_.failure("edit refused", without_ids(refused));
                   is_told_taken_ = false;  // the session's values are not those sent
                   undo_steps_.clear();     // it counts edits that the server does not have
                   forget_strokes();
                 },
                 [&](const EditsShown& shown) {
                   shown_after_ms_ = shown.latency_ms;
                   for (const std::string& id : shown.edit_ids) std::erase(tinted_, id);
                   if (tinted_.empty() && !brush_.is_drawing()) surface_->tint().clear();
                   if (colour_ == ColourBy::kBeta) forget_values();
                   forget_over();
                 },
                 [&](const PreviewShown& shown) { shown_after_ms_ = shown.latency_ms; },
                 [&](const SessionPeople& people) { people_ = people; },
                 [&](const HistoryState& history) {
                   told_ = history;
                   is_told_taken_ = false;
                   edits_known_ = std::max(edits_known_, history.edits);
                   refresh_history();
                   if (colour_ == ColourBy::kBeta) forget_values();
                   forget_over();
                   follow_seams();
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
  settings_ = told_.settings;
  if (!(curve_.curve() == settings_.curve)) curve_.set_curve(settings_.curve);
}

// Keeps the counts: they are those of the scan at this depth.
void Document::take_rims(const SessionState& state) {
  if (state.settings.controls.pin_rims) rims_ = RimCount{state.rims, state.rims_held};
}

void Document::refresh_history() {
  if (history_fetch_->running) {
    history_fetch_->again = true;
    return;
  }
  history_fetch_->running = true;
  const bool asks_rims = !rims_ && told_.settings.controls.pin_rims;
  tasks_.start([this, alive = std::weak_ptr(alive_), connection = opened_.connection,
                session = opened_.session.id, asks_rims](StopToken) -> Tasks::Completion {
    connection->bring_back();
    auto history = connection->history(session);
    std::optional<Result<SessionState>> state;
    if (asks_rims) state = connection->state(session);
    return [this, alive, history = std::move(history), state = std::move(state)] {
      if (alive.expired()) return;
      history_fetch_->running = false;
      if (state && state->is_ok()) take_rims(**state);
      if (history.is_ok()) history_ = *history;
      if (history.is_ok()) forget_over();
      follow_seams();
      if (std::exchange(history_fetch_->again, false)) refresh_history();
    };
  });
}

}  // namespace burnish
