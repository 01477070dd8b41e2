#include "server/session/edited_fields.h"

#include <algorithm>

namespace burnish {

EditedFields::EditedFields(const PreparedMesh& prepared)
    : fields_(prepared), strokes_done_{begin_series(prepared)} {}

Result<std::vector<uint64_t>> EditedFields::apply(std::span<const AuthoredEdit> edits,
                                                  const Progress& progress) {
  const auto apply_one = [&](const AuthoredEdit& edit) -> Result<uint64_t> {
    RETURN_IF_ERROR(check(edit.edit));
    return history_.apply(edit);
  };
  std::vector<uint64_t> numbers;
  Status status;
  for (const AuthoredEdit& edit : edits) {
    const Result<uint64_t> number = apply_one(edit);
    status = number.status().with_context("edit " + edit.edit.id);
    if (!status.is_ok()) break;
    numbers.push_back(number.value());
  }
  if (status.is_ok()) {
    status = replay(progress);
    if (status.is_ok()) return numbers;
  }
  for (size_t i = 0; i < numbers.size(); ++i) history_.take_back();
  (void)replay({});
  return status;
}

Result<uint64_t> EditedFields::restore(std::span<const AuthoredEdit> edits,
                                       const Progress& progress) {
  uint64_t skipped = 0;
  for (const AuthoredEdit& edit : edits) {
    AuthoredEdit kept = edit;
    const Status status = check(edit.edit);
    if (!status.is_ok()) kept.edit.change = Damaged{status.message()};
    if (!history_.restore(std::move(kept))) ++skipped;
  }
  RETURN_IF_ERROR(replay(progress));
  return skipped;
}

Status EditedFields::check(const Edit& edit) const {
  RETURN_IF_ERROR(validate(edit));
  const auto* cells = std::get_if<SetCellFields>(&edit.change);
  return cells ? fields_.check(*cells) : Status::ok();
}

EditedFields::Counting EditedFields::counting() const {
  Counting counting;
  const SetTransferCurve* curve = nullptr;
  for (const History::Entry& entry : history_.entries()) {
    if (!entry.enabled) continue;
    const auto& change = entry.made_by->edit.change;
    if (std::holds_alternative<Stroke>(change)) counting.strokes.push_back(&entry);
    if (std::holds_alternative<SetCellFields>(change)) counting.cells.push_back(&entry);
    if (const auto* slider = std::get_if<SetGradientScale>(&change)) counting.slider = *slider;
    if (const auto* found = std::get_if<SetTransferCurve>(&change)) curve = found;
  }
  if (curve) counting.curve = *curve;
  return counting;
}

Status EditedFields::replay(const Progress& progress) {
  const Counting wanted = counting();
  RETURN_IF_ERROR(replay_strokes(wanted, progress));
  replay_cells(wanted);
  if (wanted.slider.beta != fields_.gradient_scale()) {
    fields_.set_gradient_scale(wanted.slider.beta);
    changes_.beta = true;
  }
  if (wanted.curve.curve != fields_.transfer_curve()) {
    fields_.set_transfer_curve(wanted.curve.curve);
    changes_.metric = true;
  }
  return Status::ok();
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

Status EditedFields::replay_strokes(const Counting& wanted, const Progress& progress) {
  std::vector<uint64_t> series = {strokes_done_.front()};
  for (const History::Entry* entry : wanted.strokes)
    series.push_back(extend_series(series.back(), entry->stroke_hash));
  if (series == strokes_done_) return Status::ok();
  changes_.beta = true;

  const auto [fork, unused] =
      std::mismatch(strokes_done_.begin(), strokes_done_.end(), series.begin(), series.end());
  const bool goes_on = fork == strokes_done_.end();
  const size_t shared = goes_on ? strokes_done_.size() - 1 : 0;
  if (const PaintCheckpoint* nearest = checkpoints_.find(series, shared)) {
    fields_.set_painted(nearest->painted);
    strokes_done_.assign(series.begin(), series.begin() + nearest->strokes + 1);
  } else if (!goes_on) {
    fields_.set_painted({});
    strokes_done_.resize(1);
  }
  for (size_t i = strokes_done_.size() - 1; i < wanted.strokes.size(); ++i) {
    if (!report(progress, "replaying strokes", double(i) / double(wanted.strokes.size())))
      return cancelled("the replay was cancelled");
    fields_.paint(std::get<Stroke>(wanted.strokes[i]->made_by->edit.change));
    ++painted_strokes_;
    strokes_done_.push_back(series[i + 1]);
    keep_checkpoint(wanted.strokes.size());
  }
  return Status::ok();
}

void EditedFields::keep_checkpoint(uint64_t newest) {
  const uint64_t strokes = strokes_done_.size() - 1;
  if (!PaintCheckpoints::is_worth_keeping(strokes, newest)) return;
  PaintCheckpoint checkpoint{strokes_done_.back(), strokes, fields_.painted()};
  if (strokes % kStrokesPerKeptCheckpoint == 0) kept_.push_back(checkpoint);
  checkpoints_.add(std::move(checkpoint));
}

}  // namespace burnish
