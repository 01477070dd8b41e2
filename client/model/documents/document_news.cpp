#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>

#include "client/model/documents/document.h"
#include "client/surface/texture_supply.h"
#include "client/tools/colours.h"

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
  shows_previews_ = news.shows_previews;
  const bool shows_values = link_ == LinkState::kLive && shows_previews_ && stats_.frame.settled;
  is_trial_leaving_ &= !shows_values;
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
                   ++refusals_;
                   is_told_taken_ = false;  // the session's values are not those sent
                   undo_steps_.clear();     // it counts edits that the server does not have
                   end_trial();
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
                   finder_.follow(seams_now());
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
      finder_.follow(seams_now());
      if (std::exchange(history_fetch_->again, false)) refresh_history();
    };
  });
}

// The values that colour the surface.

static int8_t to_mark(float signed_part) {
  return static_cast<int8_t>(std::lround(127 * std::clamp(signed_part, -1.0f, 1.0f)));
}

static bool is_one_per_vertex(const PageValues& values, size_t vertices) {
  return values.steps.empty() || values.steps.size() == vertices;
}

void Document::set_colour(ColourBy colour) {
  if (std::exchange(colour_, colour) == colour) return;
  surface_->show_colours(colour_ == ColourBy::kScan);
  surface_->marks().clear_values();
  forget_values();
}

// Old values stay until the new ones are here.
void Document::forget_values() {
  ++values_version_;
  fetched_.clear();
}

// Fetches the values of drawn pages that have none, for all of them at once.
void Document::fetch_values() {
  if (colour_ != ColourBy::kBeta && colour_ != ColourBy::kCurvature) return;
  if (is_fetching_values_) return;
  if (std::exchange(fetched_ends_, curvature_ends_) != curvature_ends_) forget_values();
  std::vector<PageId> missing;
  for (const PageId page : surface_->drawn_pages())
    if (!fetched_.contains(page)) missing.push_back(page);
  if (missing.empty()) return;
  is_fetching_values_ = true;
  fetched_.insert(missing.begin(), missing.end());  // not again if it fails
  tasks_.start([this, alive = std::weak_ptr(alive_), connection = opened_.connection,
                session = opened_.session.id, pages = std::move(missing), colour = colour_,
                version = values_version_](StopToken) -> Tasks::Completion {
    connection->bring_back();
    const bool is_beta = colour == ColourBy::kBeta;
    auto first =
        connection->page_values(session, is_beta ? CellValue::kBeta : CellValue::kKappa1, pages);
    auto second = is_beta ? first : connection->page_values(session, CellValue::kKappa2, pages);
    return [this, alive, first = std::move(first), second = std::move(second), version] {
      if (alive.expired()) return;
      is_fetching_values_ = false;
      if (version == values_version_) take_values(first, second);
    };
  });
}

// Colours by the principal curvature that is larger in size. For the gradient scale both are it.
void Document::take_values(const Result<std::vector<PageValues>>& first,
                           const Result<std::vector<PageValues>>& second) {
  const Status status = first.is_ok() ? second.status() : first.status();
  if (!status.is_ok()) return log_.failure("colours of the surface", status);
  for (size_t p = 0; p < first->size(); ++p) {
    const PageValues& one = (*first)[p];
    const PageValues& other = (*second)[p];
    const auto vertices = surface_->vertex_count(one.page);
    if (!vertices) fetched_.erase(one.page);  // it has left meanwhile, and may come back
    if (!vertices || !is_one_per_vertex(one, *vertices) || !is_one_per_vertex(other, *vertices))
      continue;
    std::vector<int8_t> marks(*vertices);
    for (size_t v = 0; v < marks.size(); ++v) {
      const float a = one.at(v), b = other.at(v);
      const float value = std::abs(b) > std::abs(a) ? b : a;
      const double range = fetched_ends_.of(value) * curve_.kappa_range();
      marks[v] = to_mark(colour_ == ColourBy::kBeta ? signed_part_of_beta(value)
                                                    : signed_part_of_kappa(value, range));
    }
    surface_->marks().set_values(one.page, std::move(marks));
  }
}

// The protected region, and where the palette's curves rule, over the surface.

void Document::show_over(bool protection, bool curves) {
  over_wish_ = {protection, curves};
}

// Older servers tell a protection as cell fields.
Document::Over Document::over_now() const {
  const auto is_protecting = [](const HistoryEntry& entry) {
    return (entry.kind == EditKind::kProtect || entry.kind == EditKind::kCellFields) &&
           entry.enabled;
  };
  const bool is_wanted = over_wish_.protection || brush_.is_drawing();
  return {is_wanted && std::ranges::any_of(history_, is_protecting),
          over_wish_.curves && !palette().curves.empty()};
}

// The old stays until the new is here.
void Document::forget_over() {
  ++over_version_;
  fetched_over_.clear();
}

// Fetches what the drawn pages lack, for all of them at once.
void Document::fetch_over() {
  const Over over = over_now();
  if (over_ != over) {
    over_ = over;
    forget_over();
    if (over == Over()) surface_->marks().clear_overlays();
  }
  if (over == Over() || is_fetching_over_) return;
  std::vector<PageId> missing;
  for (const PageId page : surface_->drawn_pages())
    if (!fetched_over_.contains(page)) missing.push_back(page);
  if (missing.empty()) return;
  is_fetching_over_ = true;
  fetched_over_.insert(missing.begin(), missing.end());  // not again if it fails
  tasks_.start([this, alive = std::weak_ptr(alive_), connection = opened_.connection,
                session = opened_.session.id, pages = std::move(missing), over,
                version = over_version_](StopToken) -> Tasks::Completion {
    connection->bring_back();
    const auto ask = [&](bool is_asked, CellValue value) -> Result<std::vector<PageValues>> {
      if (!is_asked) return std::vector<PageValues>();
      return connection->page_values(session, value, pages);
    };
    auto held = ask(over.protection, CellValue::kProtected);
    auto ruled = ask(over.curves, CellValue::kCurve);
    return [this, alive, over, held = std::move(held), ruled = std::move(ruled), version] {
      if (alive.expired()) return;
      is_fetching_over_ = false;
      if (version == over_version_) take_over(over, held, ruled);
    };
  });
}

void Document::take_over(const Over& over, const Result<std::vector<PageValues>>& held,
                         const Result<std::vector<PageValues>>& ruled) {
  const Status status = held.is_ok() ? ruled.status() : held.status();
  if (!status.is_ok()) return log_.failure("colours over the surface", status);
  const size_t pages = std::max(held->size(), ruled->size());
  for (size_t p = 0; p < pages; ++p) {
    const PageId page = over.protection ? (*held)[p].page : (*ruled)[p].page;
    const auto vertices = surface_->vertex_count(page);
    if (!vertices) fetched_over_.erase(page);  // it has left meanwhile, and may come back
    if (!vertices || (over.protection && !is_one_per_vertex((*held)[p], *vertices)) ||
        (over.curves && !is_one_per_vertex((*ruled)[p], *vertices)))
      continue;
    std::vector<uint16_t> overlays(*vertices);
    for (size_t v = 0; v < overlays.size(); ++v) {
      const long curve = over.curves ? std::lround((*ruled)[p].at(v)) : 0;
      std::optional<uint32_t> colour;
      if (curve > 0 && static_cast<size_t>(curve) <= palette().curves.size())
        colour = palette().curves[static_cast<size_t>(curve) - 1].colour;
      overlays[v] = packed_overlay(colour, over.protection && (*held)[p].at(v) > 0.5f);
    }
    surface_->marks().set_overlays(page, std::move(overlays));
  }
}

// The scan's pictures, with levelled seams.

static constexpr int kTextureRenewalsMax = 3;  // a server that always fails is asked no more

// Edits that the server has not acknowledged change no sheets. Older servers tell a protection as
// cell fields.
SeamsOfSession Document::seams_now() const {
  SeamsOfSession seams{told_.settings.texture.level_seams, {}};
  if (seams.amount == 0) return seams;
  for (const HistoryEntry& entry : history_)
    if (entry.enabled && (entry.kind == EditKind::kProtect || entry.kind == EditKind::kCellFields))
      seams.protects.push_back(entry.number);
  return seams;
}

SheetFinder::Describe Document::describe_sheets() const {
  return [connection = opened_.connection, scan = opened_.session.scan_id,
          session = opened_.session.id](const SeamsOfSession& seams, const Progress& progress) {
    return connection->describe_sheets(scan, progress, seams.amount > 0 ? session : std::string());
  };
}

// A server may have to bake the sheets first, so nobody waits for them. Vertices' colours come from
// the pictures too: a scan without colours has no sheets. An older server knows none.
void Document::find_textures() {
  if (has_textures()) finder_.find(seams_now());
}

void Document::take_textures(const Result<SheetsDescription>& found) {
  has_no_textures_yet_ = !found.is_ok();
  if (found.is_ok())
    show_textures(*found);
  else if (found.status().code() != StatusCode::kUnimplemented)
    log_.failure("textures", found.status());
}

// A link that was lost may have taken the last finding with it.
void Document::retry_textures() {
  if (has_no_textures_yet_ && !finder_.is_finding()) find_textures();
}

// Another server of a fleet has no sheets until somebody describes them, nor one whose file is
// damaged, or whose levelled sheets had to make room.
void Document::renew_textures() {
  if (finder_.is_finding() || texture_renewals_left_ == 0 || !surface_->take_sheet_damage()) return;
  --texture_renewals_left_;
  renews_textures_ = true;
  find_textures();
}

void Document::show_textures(const SheetsDescription& description) {
  const bool renews = std::exchange(renews_textures_, false);
  if (!description.has_sheets()) return;
  const TextureSupply* shown = surface_->textures();
  const bool is_same = shown != nullptr && shown->version() == description.version;
  if (is_same && !renews) return;
  if (!is_same) texture_renewals_left_ = kTextureRenewalsMax;
  auto textures =
      TextureSupply::open(description, {surface_->head(), surface_->pages_fingerprint(),
                                        surface_->texture_bytes_max(), surface_->on_news()});
  if (!textures.is_ok()) return log_.failure("textures", textures.status());
  surface_->set_textures(std::move(*textures));
}

}  // namespace burnish
