#include "server/session/edited_fields.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace burnish {

EditedFields::EditedFields(const PreparedMesh& prepared, const Controls& initial)
    : prepared_(prepared),
      fields_(prepared),
      initial_(initial),
      protection_(prepared),
      strokes_done_{begin_series(prepared)} {
  fields_.set({.controls = initial});
  hold_rims();
}

Result<std::vector<uint64_t>> EditedFields::record(std::span<const AuthoredEdit> edits) {
  const auto record_one = [&](const AuthoredEdit& edit) -> Result<uint64_t> {
    RETURN_IF_ERROR(check(edit.edit));
    return history_.apply(edit);
  };
  std::vector<uint64_t> numbers;
  for (const AuthoredEdit& edit : edits) {
    const Result<uint64_t> number = record_one(edit);
    if (!number.is_ok()) {
      for (size_t i = 0; i < numbers.size(); ++i) history_.take_back();
      return about_edit(number.status(), edit.edit, edits.size());
    }
    numbers.push_back(number.value());
  }
  is_behind_ |= !numbers.empty();
  return numbers;
}

Result<std::vector<uint64_t>> EditedFields::apply(std::span<const AuthoredEdit> edits,
                                                  const Progress& progress) {
  ASSIGN_OR_RETURN(std::vector<uint64_t> numbers, record(edits));
  const Status status = catch_up(progress);
  if (status.is_ok()) return numbers;
  for (size_t i = 0; i < numbers.size(); ++i) history_.take_back();
  is_behind_ = true;
  (void)catch_up({});
  return status;
}

uint64_t EditedFields::restore(std::span<const AuthoredEdit> edits) {
  uint64_t skipped = 0;
  for (const AuthoredEdit& edit : edits) {
    AuthoredEdit kept = edit;
    const Status status = check(edit.edit);
    if (!status.is_ok()) kept.edit.change = Damaged{status.message()};
    if (!history_.restore(std::move(kept))) ++skipped;
  }
  is_behind_ |= !edits.empty();
  return skipped;
}

Status EditedFields::check(const Edit& edit) const {
  RETURN_IF_ERROR(validate(edit));
  const auto* cells = std::get_if<SetCellFields>(&edit.change);
  return cells ? fields_.check(*cells) : Status::ok();
}

LayerCheck EditedFields::layers() const {
  const Counting now = counting();
  return {now.settings, now.paints_edges};
}

/// The least volume that a scan can keep, over its area times its diagonal. Below that the volume
/// is what rounding leaves where pieces that are inside out take it from the others.
static constexpr double kVolumeShareMin = 1e-6;

static Status check_volume(const PreparedMesh& prepared) {
  if (!is_closed(prepared))
    return failed_precondition("the scan is not closed, so it has no volume to keep");
  const MeshStatistics& scan = prepared.statistics;
  const double least = kVolumeShareMin * scan.area * scan.diagonal();
  if (std::abs(scan.signed_volume) >= least) return Status::ok();
  char text[200];
  std::snprintf(text, sizeof text,
                "the scan's volume of %.3g cannot be kept: it must be at least %.3g; a piece that "
                "is inside out takes its volume from the others",
                std::abs(scan.signed_volume), least);
  return failed_precondition(text);
}

Status EditedFields::check_new(const Edit& edit) const {
  const auto* bounds = std::get_if<SetControls>(&edit.change);
  if (bounds && bounds->controls.keep_volume) RETURN_IF_ERROR(check_volume(prepared_));
  if (needs_colours(edit.change) && prepared_.colours.empty())
    return failed_precondition("the scan has no colours to edit");
  if (const auto* cells = std::get_if<SetCellFields>(&edit.change))
    return fields_.check_new(*cells);
  if (const auto* stroke = std::get_if<Stroke>(&edit.change)) return check_new(*stroke);
  return Status::ok();
}

// A region that the fields have not caught up with may be released.
Status EditedFields::check_new(const Stroke& stroke) const {
  RETURN_IF_ERROR(fields_.check_new(stroke));
  const auto is_free = [&](int64_t cell) { return !protection_.has(static_cast<size_t>(cell)); };
  if (is_behind_ || protection_.is_empty() || fields_.touches(stroke, is_free)) return Status::ok();
  return failed_precondition("nothing painted: the region is protected");
}

static bool sets_cells(const Change& change, CellTarget target) {
  const auto* cells = std::get_if<SetCellFields>(&change);
  return cells && cells->target == target;
}

EditedFields::Counting EditedFields::counting() const {
  Counting counting;
  counting.settings.controls = initial_;
  std::array<const Change*, std::variant_size_v<Change>> last{};  // of each kind
  for (const History::Entry& entry : history_.entries()) {
    if (!entry.enabled) continue;
    const Change& change = entry.made_by->edit.change;
    last[change.index()] = &change;
    if (const auto layer = painted_layer(change)) {
      counting.strokes.push_back(&entry);
      counting.paints_edges |= *layer == kEdgesLayer;
      counting.protects_before.push_back(counting.protects.size());
    }
    if (sets_cells(change, CellTarget::kFields)) counting.cells.push_back(&entry);
    if (std::holds_alternative<Protect>(change) || sets_cells(change, CellTarget::kProtection))
      counting.protects.push_back(&entry);
  }
  for (const Change* change : last)
    if (change) counting.settings.take(*change);
  counting.settings = counting_beside_edges(std::move(counting.settings), counting.paints_edges);
  return counting;
}

Status EditedFields::catch_up(const Progress& progress) {
  if (!is_behind_) return Status::ok();
  const Counting wanted = counting();
  RETURN_IF_ERROR(replay_strokes(wanted, progress));
  replay_cells(wanted);
  set(wanted.settings);
  if (replay_protects(wanted)) hold_region();
  hold_rims();
  is_behind_ = false;
  return Status::ok();
}

void EditedFields::set(const Settings& settings) {
  const Settings& before = fields_.settings();
  EditEffects effects = effects_between(before, settings);
  // A palette makes new matrices only where one of its curves is painted.
  if (!fields_.has_painted_curves()) effects.metric = settings.curve != before.curve;
  changes_ |= effects;
  fields_.set(settings);
}

/// Makes the protected region of these entries.
void EditedFields::protect_by(std::span<const History::Entry* const> entries) {
  const bool goes_on =
      protects_applied_.size() <= entries.size() &&
      std::equal(protects_applied_.begin(), protects_applied_.end(), entries.begin(),
                 [](uint64_t number, const auto* entry) { return number == entry->number; });
  if (!goes_on) {
    protection_.clear();
    protects_applied_.clear();
  }
  for (const History::Entry* entry : entries.subspan(protects_applied_.size())) {
    const Change& change = entry->made_by->edit.change;
    if (const auto* cells = std::get_if<SetCellFields>(&change)) {
      protection_.apply(*cells);
    } else {
      protection_.apply(std::get<Protect>(change));
    }
    protects_applied_.push_back(entry->number);
  }
}

/// Returns whether the protected region has changed.
bool EditedFields::replay_protects(const Counting& wanted) {
  protect_by(wanted.protects);
  return std::exchange(protects_done_, protects_applied_) != protects_applied_;
}

/// Holds the protected region, for shape and colours.
void EditedFields::hold_region() {
  const bool was_held = fields_.hold() != nullptr;
  fields_.set_hold(std::make_shared<const Hold>(make_hold(prepared_, protection_.cells())));
  if (!prepared_.colours.empty()) fields_.set_colour_hold(fields_.hold());
  changes_.metric |= was_held || fields_.hold() != nullptr;
}

/// Holds the rims, if they are pinned.
void EditedFields::hold_rims() {
  if (controls().pin_rims && !rims_)
    rims_ = std::make_shared<const HeldRims>(find_held_rims(prepared_));
  const auto wanted = controls().pin_rims && rims_->held > 0 ? rims_ : nullptr;
  changes_.metric |= wanted != fields_.rims();
  fields_.set_rims(wanted);
}

void EditedFields::replay_cells(const Counting& wanted) {
  std::vector<uint64_t> numbers;
  for (const History::Entry* entry : wanted.cells) numbers.push_back(entry->number);
  if (numbers == cells_done_) return;
  const bool goes_on = cells_done_.size() < numbers.size() &&
                       std::equal(cells_done_.begin(), cells_done_.end(), numbers.begin());
  if (!goes_on) fields_.clear_overrides();
  for (size_t i = goes_on ? cells_done_.size() : 0; i < wanted.cells.size(); ++i) {
    const Edit& edit = wanted.cells[i]->made_by->edit;
    const Status status = fields_.override_cells(std::get<SetCellFields>(edit.change));
    BURNISH_CHECK(status.is_ok(), "cells are checked before they enter the history");
  }
  cells_done_ = std::move(numbers);
  changes_.metric = true;
}

/// Returns the hash after each stroke. Regions that are protected before a stroke are part of it.
std::vector<uint64_t> EditedFields::series_of(const Counting& counting, uint64_t begin) {
  std::vector<uint64_t> series = {begin};
  uint64_t region = 0;  // hash of the region before the stroke; 0: none
  size_t protects = 0;
  for (size_t i = 0; i < counting.strokes.size(); ++i) {
    for (; protects < counting.protects_before[i]; ++protects)
      region = extend_series(region, counting.protects[protects]->number);
    const uint64_t hash = counting.strokes[i]->stroke_hash;
    series.push_back(
        extend_series(series.back(), region == 0 ? hash : extend_series(hash, region)));
  }
  return series;
}

Status EditedFields::replay_strokes(const Counting& wanted, const Progress& progress) {
  const std::vector<uint64_t> series = series_of(wanted, strokes_done_.front());
  if (series == strokes_done_ && !begun_) return Status::ok();
  const Fields::PaintVersions before = fields_.paint_versions();
  const Status painted = paint_strokes(wanted, series, progress);
  const Fields::PaintVersions& after = fields_.paint_versions();
  changes_ |= {.metric = after.curves != before.curves,
               .beta = after.beta != before.beta || after.edges != before.edges,
               .shown = after.gains != before.gains || after.colour != before.colour ||
                        after.texture != before.texture};
  return painted;
}

Status EditedFields::paint_strokes(const Counting& wanted, const std::vector<uint64_t>& series,
                                   const Progress& progress) {
  go_back_to_shared(series);
  for (size_t i = strokes_done_.size() - 1; i < wanted.strokes.size(); ++i) {
    protect_by(std::span(wanted.protects).first(wanted.protects_before[i]));
    const Change& change = wanted.strokes[i]->made_by->edit.change;
    const double done = double(i) / double(wanted.strokes.size());
    RETURN_IF_ERROR(paint(change, series[i + 1], progress, done));
    ++painted_strokes_;
    strokes_done_.push_back(series[i + 1]);
    keep_checkpoint(wanted.strokes.size());
  }
  return Status::ok();
}

/// Removes strokes that do not lead to `series` from the fields, by the nearest checkpoint.
void EditedFields::go_back_to_shared(const std::vector<uint64_t>& series) {
  const auto [fork, unused] =
      std::mismatch(strokes_done_.begin(), strokes_done_.end(), series.begin(), series.end());
  const bool goes_on =
      fork == strokes_done_.end() && (!begun_ || (strokes_done_.size() < series.size() &&
                                                  series[strokes_done_.size()] == begun_->series));
  const size_t shared = goes_on ? strokes_done_.size() - 1 : 0;
  if (const PaintCheckpoint* nearest = checkpoints_.find(series, shared)) {
    fields_.set_painted(nearest->painted);
    strokes_done_.assign(series.begin(), series.begin() + nearest->strokes + 1);
  } else if (!goes_on) {
    fields_.set_painted({});
    strokes_done_.resize(1);
  } else {
    return;
  }
  begun_.reset();
}

Status EditedFields::paint(const Change& change, uint64_t series, const Progress& progress,
                           double done) {
  if (const auto* stroke = std::get_if<Stroke>(&change))
    return paint(*stroke, series, progress, done);
  fields_.paint(std::get<SetCellFields>(change),
                [&](int64_t cell) { return protection_.has(static_cast<size_t>(cell)); });
  return Status::ok();
}

/// Paints the rest of the stroke outside of the protection, some cells between two calls of
/// `progress`.
Status EditedFields::paint(const Stroke& stroke, uint64_t series, const Progress& progress,
                           double done) {
  if (!begun_) begin(stroke, series);
  do {
    if (!report(progress, "replaying strokes", done)) return cancelled("the replay was cancelled");
  } while (!paint_on(stroke.brush));
  begun_.reset();
  return Status::ok();
}

void EditedFields::begin(const Stroke& stroke, uint64_t series) {
  begun_.emplace(series, dab_centres(stroke));
  if (stroke.brush.connected) {
    begun_->dabs.emplace(fields_.connected_dabs(stroke.brush, begun_->centres));
    return;
  }
  begun_->cells = fields_.cells_near(stroke.brush, begun_->centres);
  std::erase_if(begun_->cells,
                [&](int64_t cell) { return protection_.has(static_cast<size_t>(cell)); });
}

/// Does some milliseconds of work at the stroke that is begun. Returns whether it is painted. Each
/// cell sees all dabs at once, so pauses leave no trace in its paint.
bool EditedFields::paint_on(const Brush& brush) {
  static constexpr size_t kDabsTimesCells = 1 << 22, kConnectedCells = 1 << 14;
  if (begun_->dabs) {
    if (!begun_->dabs->advance(kConnectedCells)) return false;
    fields_.paint(brush, *begun_->dabs,
                  [&](int64_t cell) { return protection_.has(static_cast<size_t>(cell)); });
    return true;
  }
  const size_t cells_at_once = std::max(kDabsTimesCells / begun_->centres.size(), size_t{1});
  const auto left = std::span(begun_->cells).subspan(begun_->painted_cells);
  const auto now = left.first(std::min(left.size(), cells_at_once));
  fields_.paint(brush, begun_->centres, now);
  begun_->painted_cells += now.size();
  return begun_->painted_cells == begun_->cells.size();
}

void EditedFields::keep_checkpoint(uint64_t newest) {
  const uint64_t strokes = strokes_done_.size() - 1;
  if (!PaintCheckpoints::is_worth_keeping(strokes, newest)) return;
  PaintCheckpoint checkpoint{strokes_done_.back(), strokes, fields_.painted()};
  if (strokes % kStrokesPerKeptCheckpoint == 0) kept_.push_back(checkpoint);
  checkpoints_.add(std::move(checkpoint));
}

}  // namespace burnish
