#include "client/model/documents/document.h"

#include <algorithm>

#include "client/connection/links.h"
#include "client/model/documents/figures.h"
#include "client/model/documents/undo_words.h"
#include "common/edit/edit_id.h"
#include "common/edit/preview_change.h"
#include "common/edit/wavelength.h"

namespace burnish {

static double kappa_range(const ScanDescription& scan) {
  constexpr double kWithoutHistogram = 100;
  return scan.prepared && scan.prepared->histogram_range > 0 ? scan.prepared->histogram_range
                                                             : kWithoutHistogram;
}

/// Returns the upper end of the slider and the plot: a fine grid holds waves of large α.
static double alpha_max(const ScanDescription& scan) {
  if (!scan.prepared || !(scan.prepared->cell_size > 0)) return kFidelityMax;
  return std::max(kFidelityMax,
                  alpha_of_grid_limit(scan.prepared->length_unit, scan.prepared->cell_size));
}

Document::Document(OpenedDocument opened, Tasks& tasks, MessageLog& log, Recorder& recorder,
                   DocumentOptions options)
    : opened_(std::move(opened)),
      tasks_(tasks),
      log_(log),
      recorder_(recorder),
      settings_(opened_.state.settings),
      curve_(kappa_range(opened_.scan), settings_.curve, alpha_max(opened_.scan)),
      history_(std::move(opened_.history)),
      edits_known_(opened_.session.edits),
      told_{edits_known_, settings_},
      measuring_(opened_.connection, opened_.session.id, tasks, log),
      noise_(opened_.connection, opened_.session.scan_id, tasks, log),
      finder_(tasks, describe_sheets(), [this](const auto& found) { take_textures(found); }) {
  take_rims(opened_.state);
  if (has_colours()) colour_ = ColourBy::kScan;
  welcome_.session = opened_.session;
  welcome_.role = SessionRole::kEditor;  // until the server tells the role
  const MeshStatistics& statistics = opened_.scan.scan.statistics;
  box_ = {statistics.box_min, statistics.box_max};
  LiveOptions live;
  live.greeting = {opened_.session.id, std::nullopt};
  live.head = opened_.pages.head;
  live.depth = depth();
  live.pages_fingerprint = opened_.pages.fingerprint;
  live.on_news = options.wake;
  live.clock = options.clock;
  live_ = make_live_link(*opened_.connection, std::move(live));
  auto source = make_page_source(
      *opened_.connection,
      {opened_.pages.scan, opened_.pages.fingerprint, std::move(options.pages), options.wake});
  SurfaceOptions shown{options.budget, options.is_software, options.wake, options.clock};
  surface_ = std::make_unique<PagedSurface>(std::move(opened_.pages), depth(), std::move(source),
                                            *live_, std::move(shown));
  surface_->show_colours(has_colours());
}

Status Document::open(PageRenderer& renderer) {
  RETURN_IF_ERROR(surface_->open(renderer));
  find_textures();
  return Status::ok();
}

void Document::send(Change change) {
  send_as(random_id(), std::move(change));
}

void Document::send_as(const std::string& id, Change change) {
  send_together({{id, std::move(change)}});
}

// Takes the place of what a preset would set, or takes it back.
static bool is_of_filter(const Change& change) {
  return std::holds_alternative<SetGradientScale>(change) ||
         std::holds_alternative<SetTransferCurve>(change) ||
         std::holds_alternative<SetEqualiser>(change) || std::holds_alternative<SetEdges>(change) ||
         std::holds_alternative<Undo>(change);
}

// The server applies all of a message or none.
void Document::send_together(const std::vector<Edit>& edits) {
  end_trial();
  for (const Edit& edit : edits) {
    if (std::holds_alternative<SetEdges>(edit.change)) waits_for_noise_ = false;
    if (is_of_filter(edit.change)) waiting_preset_.reset();
    settings_.take(edit.change);
    recorder_.record(edit);
  }
  const Status sent = live_->apply(edits);
  if (!sent.is_ok()) {
    log_.failure("edit", sent);
    ++refusals_;
    is_told_taken_ = false;  // the session's values are not those of the edits
    return forget_strokes();
  }
  unacknowledged_ += edits.size();
  for (const Edit& edit : edits) count_step(edit.change);
  for (size_t joined = 1; joined < edits.size(); ++joined) undo_steps_.join_last_two();
}

void Document::count_step(const Change& change) {
  if (std::holds_alternative<SwitchEntry>(change) ||
      std::holds_alternative<RestoreCheckpoint>(change))
    return undo_steps_.clear();
  if (makes_fields(kind_of({{}, change}))) undo_steps_.add();
}

void Document::preview(Change change) {
  end_trial();
  settings_.take(change);
  auto shown = preview_of(std::move(change));
  if (!shown) return;
  if (gesture_.empty()) gesture_ = random_id();
  live_->preview(gesture_, std::move(*shown));
}

void Document::commit(Change change) {
  commit_together({std::move(change)});
}

void Document::edit(Change change) {
  if (const auto* stroke = std::get_if<Stroke>(&change)) return paint(*stroke);
  if (const auto* set = std::get_if<SetTransferCurve>(&change)) {
    curve_.set_curve(set->curve);
    return commit_curve();
  }
  if (std::holds_alternative<Undo>(change)) return undo();
  if (std::holds_alternative<Redo>(change)) return redo();
  preview_of(change) ? commit(std::move(change)) : send(std::move(change));
}

// The first edit ends a drag, so it is of the value that the drag moved.
void Document::commit_together(std::vector<Change> changes) {
  std::vector<Edit> edits;
  for (Change& change : changes) {
    const std::string id = gesture_.empty() ? random_id() : std::exchange(gesture_, {});
    edits.push_back({id, std::move(change)});
  }
  send_together(edits);
}

void Document::undo() {
  goes_on_ = false;
  for (int edits = undo_steps_.undo(undo_name(*this)); edits > 0; --edits) send(Undo{});
}

void Document::redo() {
  for (int edits = undo_steps_.redo(); edits > 0; --edits) send(Redo{});
}

void Document::begin_stroke(BrushMode mode, const Vec3d& point, double pressure) {
  brush_.begin(mode, point, pressure);
  goes_on_ = false;
  if (brush_.brush.edges && edges() == EdgeFilter{}) noise_.ask();
  show_begun_stroke();
}

void Document::show_begun_stroke() {
  end_trial();
  gesture_ = random_id();
  last_dab_ = brush_.stroke().path.front();
  tint_dab(brush_.stroke().brush, last_dab_);
  live_->preview(gesture_, Stroke{brush_.stroke().brush, brush_.take_new_points()});
}

void Document::extend_stroke(const Vec3d& point, double pressure) {
  while (const auto start = brush_.extend(point, pressure)) {
    show_new_points();
    end_stroke();
    goes_on_ = true;
    brush_.go_on(*start, pressure);
    show_begun_stroke();
  }
  show_new_points();
}

void Document::show_new_points() {
  const std::vector<Vec3d> points = brush_.take_new_points();
  if (points.empty()) return;
  add_dabs(points);
  live_->preview(gesture_, Stroke{brush_.stroke().brush, points});
}

// Tints the dabs that the server will paint along these points.
void Document::add_dabs(const std::vector<Vec3d>& points) {
  Stroke way{brush_.stroke().brush, {last_dab_}};
  way.path.insert(way.path.end(), points.begin(), points.end());
  const std::vector<Vec3d> dabs = dab_centres(way);
  for (size_t i = 1; i < dabs.size(); ++i) tint_dab(way.brush, dabs[i]);
  last_dab_ = dabs.back();
}

void Document::tint_dab(const Brush& brush, const Vec3d& centre) {
  surface_->tint().add_dab(brush, centre);
  if (mirror) surface_->tint().add_dab(brush, mirrored(centre, *mirror));
}

void Document::end_stroke() {
  const std::string id = std::exchange(gesture_, {});
  const Stroke stroke = brush_.end();
  const auto filter = stroke.brush.edges ? filter_for_paint() : std::nullopt;
  paints_for_noise_ = stroke.brush.edges && noise_.is_asking();
  if (filter) send(SetEdges{*filter});
  send_stroke(id, stroke);
  if (filter) undo_steps_.join_last_two();
  if (goes_on_) undo_steps_.join_last_two();
}

void Document::paint(const Stroke& stroke) {
  send_stroke(random_id(), stroke);
}

// The tint of both goes when a frame shows the last one.
void Document::send_stroke(const std::string& id, const Stroke& stroke) {
  tinted_.push_back(id);
  send_as(id, stroke);
  if (!mirror) return;
  const std::string other = random_id();
  tinted_.push_back(other);
  send_as(other, mirrored(stroke, *mirror));
  undo_steps_.join_last_two();
}

void Document::cancel_stroke() {
  brush_.cancel();
  live_->drop_preview(std::exchange(gesture_, {}));
  surface_->tint().clear();
}

// Forgets strokes that no frame will show.
void Document::forget_strokes() {
  if (brush_.is_drawing()) cancel_stroke();
  tinted_.clear();
  surface_->tint().clear();
}

void Document::set_role(const std::string& user, SessionRole role) {
  tasks_.start([connection = opened_.connection, session = opened_.session.id, user, role,
                &log = log_](StopToken) -> Tasks::Completion {
    connection->bring_back();
    const Status status = connection->set_role(session, user, role);
    return [status, &log] {
      if (!status.is_ok()) log.failure("role", status);
    };
  });
}

void Document::name_unit(const std::string& unit) {
  const Status checked = check_unit(unit);
  if (!checked.is_ok()) return log_.failure("unit", checked);
  tasks_.start([this, alive = std::weak_ptr(alive_), connection = opened_.connection,
                scan = opened_.session.scan_id, unit](StopToken) -> Tasks::Completion {
    connection->bring_back();
    const auto named = connection->set_scan_unit(scan, unit);
    return [this, alive, named] {
      if (alive.expired()) return;
      if (!named.is_ok()) return log_.failure("unit", named.status());
      opened_.scan.scan.unit = named->unit;
    };
  });
}

bool Document::is_settled() const {
  return link_ == LinkState::kLive && gesture_.empty() && trial_.empty() && !waiting_preset_ &&
         !is_trial_leaving_ && stats_.frames > 0 && stats_.frame.settled &&
         stats_.frame.edits >= edits_known_ && has_newest_history();
}

bool Document::is_picture_fine() const {
  return surface_->is_settled() && !finder_.is_finding() && has_newest_seams() &&
         !is_fetching_values_ && !is_fetching_over_;
}

bool Document::has_all_colours() const {
  if (is_fetching_values_ || is_fetching_over_) return false;
  if (colour_ != ColourBy::kScan || !has_textures()) return true;
  return !finder_.is_finding() && !has_no_textures_yet_ && has_newest_seams() &&
         surface_->has_all_texels();
}

std::string Document::picture_lack() const {
  const std::string simplified = simplified_text(surface_->status());
  if (!simplified.empty()) return simplified;
  return has_all_colours() ? std::string() : "colours incomplete";
}

// Presets, and which of them is in force.

ScanLengths Document::lengths() const {
  return {length_unit(),     cell_size(),
          mean_edge(),       sharp_bend_of(prepared().histogram_range, prepared().histogram),
          noise_.proposal(), !controls().keep_volume};
}

void Document::apply(const Preset& preset, double strength) {
  waiting_preset_.reset();
  if (!follows_noise(preset) || noise_.proposal()) return apply_now(preset, strength);
  waiting_preset_ = PresetInForce{preset, strength};
  noise_.ask();
}

// Edges end before bands begin and the other way round, for they exclude each other.
void Document::apply_now(const Preset& preset, double strength) {
  PresetFilter applied = filter_of(preset, strength, lengths());
  last_preset_ = preset;
  curve_.set_curve(applied.curve);
  if (preset.brush_beta && !brush_.brush.has_own_limits()) brush_.brush.beta = *preset.brush_beta;
  const bool has_bands = !applied.equaliser.bands.empty() || !equaliser().bands.empty();
  std::vector<Change> changes;
  if (has_bands) changes.push_back(SetEqualiser{std::move(applied.equaliser)});
  if (changes_edges(applied, edges()))
    changes.insert(applied.edges->is_on() ? changes.end() : changes.begin(),
                   SetEdges{*applied.edges});
  changes.push_back(SetTransferCurve{curve_.curve()});
  changes.push_back(SetGradientScale{applied.beta});
  commit_together(std::move(changes));
}

TransferCurve Document::curve_for_edges() const {
  return TransferCurve(alpha_of_wavelength(length_unit(), kEdgeWaveEdges * mean_edge()));
}

void Document::keep_edges(const EdgeFilter& preset) {
  const TransferCurve before = curve_.curve();
  if (before != curve_for_edges()) curve_before_edges_ = before;
  curve_.set_curve(curve_for_edges());
  commit_together({SetEdges{preset}, SetTransferCurve{curve_.curve()}});
}

void Document::keep_no_edges() {
  if (curve_.curve() != curve_for_edges()) return commit(SetEdges{});
  curve_.set_curve(curve_before_edges_);
  commit_together({SetEdges{}, SetTransferCurve{curve_.curve()}});
}

void Document::keep_edges_by_noise() {
  waits_for_noise_ = true;
  noise_.ask();
  take_noise();
}

// A commit would end a drag or a stroke, so the answer waits for their end.
void Document::take_noise() {
  if (noise_.is_asking() || !gesture_.empty()) return;
  if (const auto preset = std::exchange(waiting_preset_, std::nullopt))
    apply_now(preset->preset, preset->strength);
  const bool is_painted = std::exchange(paints_for_noise_, false);
  if (!std::exchange(waits_for_noise_, false)) {
    const auto filter = is_painted ? filter_for_paint() : std::nullopt;
    if (filter) send(SetEdges{*filter});
    return;
  }
  const auto& proposal = noise_.proposal();
  if (!proposal) return;
  if (proposal->filter.is_on()) return keep_edges(proposal->filter);
  log_.info(noise_text(*this));
}

// Strength 0 stays: only what is painted is denoised.
std::optional<EdgeFilter> Document::filter_for_paint() const {
  const auto& proposal = noise_.proposal();
  if (!proposal || !proposal->filter.is_on() || edges() != EdgeFilter{}) return std::nullopt;
  EdgeFilter filter = proposal->filter;
  filter.strength = 0;
  return filter;
}

bool Document::keeps_edges_by_noise() const {
  const auto& proposal = noise_.proposal();
  if (!proposal || !proposal->filter.is_on() || !edges().is_on()) return false;
  EdgeFilter whole = edges();
  whole.strength = proposal->filter.strength;
  return whole == proposal->filter;
}

void Document::preview_strength(const Preset& preset, double strength) {
  PresetFilter passed = filter_of(preset, strength, lengths());
  last_preset_ = preset;
  if (preset.bands.empty()) return preview_beta(passed.beta);
  preview(SetEqualiser{std::move(passed.equaliser)});
}

void Document::commit_strength(const Preset& preset) {
  if (preset.bands.empty()) return commit_beta();
  commit(SetEqualiser{equaliser()});
}

// A preview has one change.
bool Document::has_trial(const Preset& preset) {
  return preset.bands.empty() ? preset.beta != 1 : preset.beta == 1;
}

void Document::try_strength(const Preset& preset, double strength) {
  PresetFilter tried = filter_of(preset, strength, lengths());
  if (trial_.empty()) trial_ = random_id();
  shows_previews_ = false;
  preset.bands.empty() ? live_->preview(trial_, SetGradientScale{tried.beta})
                       : live_->preview(trial_, SetEqualiser{std::move(tried.equaliser)});
}

void Document::end_trial() {
  if (trial_.empty()) return;
  live_->drop_preview(std::exchange(trial_, {}));
  shows_previews_ = false;
  is_trial_leaving_ = true;
}

bool Document::shows_trial() const {
  return is_trying() && link_ == LinkState::kLive && shows_previews_ && stats_.frame.settled;
}

std::optional<PresetInForce> Document::preset_in_force(const std::vector<Preset>& own) const {
  const PresetFilter now = filter();
  if (last_preset_) {
    if (const auto strength = strength_of(*last_preset_, now, lengths()))
      return PresetInForce{*last_preset_, *strength};
    const PresetFilter none = filter_of(*last_preset_, 0, lengths());
    const bool is_dragged = !gesture_.empty();
    if (is_dragged && now.beta == none.beta && now.equaliser == none.equaliser)
      return PresetInForce{*last_preset_, 0};
  }
  for (const auto* all : {&own, &presets()})
    for (const Preset& preset : *all)
      if (strength_of(preset, now, lengths()) == 1) return PresetInForce{preset, 1};
  return std::nullopt;
}

}  // namespace burnish
