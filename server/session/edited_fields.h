#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/base/progress.h"
#include "server/session/history.h"
#include "server/session/paint_checkpoints.h"
#include "server/solver/fields.h"

namespace burnish {

/// The history of a session and the fields that it makes. Every change, whether a new edit, an
/// undo, a late join, a recovery or a fork, comes about in the same way: the history first, then
/// a replay of those entries that are on and not yet in the fields. The fields depend on the order
/// of the edits alone, not on how they came in batches.
class EditedFields {
 public:
  /// Needs: prepared outlives this.
  explicit EditedFields(const PreparedMesh& prepared);

  /// What has changed, in the terms of the solver.
  struct Changes {
    bool metric = false;  ///< α1, α2: new matrices
    bool beta = false;    ///< a new constraint

    bool any() const { return metric || beta; }
    Changes& operator|=(const Changes& other) {
      metric |= other.metric;
      beta |= other.beta;
      return *this;
    }
  };

  /// Applies all edits or none. Returns the number that History::apply gives for each.
  /// Needs: ids that the history does not know. Fails: as validate() and History::apply() do, and
  /// for a cell that is not active, naming the edit; cancelled.
  Result<std::vector<uint64_t>> apply(std::span<const AuthoredEdit> edits,
                                      const Progress& progress = {});

  /// What the mesh has against an edit that is new: apply() takes what older histories hold.
  /// Fails: invalid_argument for a cell that is not active or set twice.
  Status check_new(const Edit& edit) const {
    const auto* cells = std::get_if<SetCellFields>(&edit.change);
    return cells ? fields_.check_new(*cells) : Status::ok();
  }

  /// What has changed since the last take_changes().
  const Changes& changes() const { return changes_; }
  Changes take_changes() { return std::exchange(changes_, {}); }

  /// Lets a later replay begin at a checkpoint that was kept elsewhere.
  void offer(PaintCheckpoint checkpoint) { checkpoints_.add(std::move(checkpoint)); }

  /// Checkpoints that are worth keeping elsewhere, made since the last call. They bound a replay to
  /// kStrokesPerKeptCheckpoint strokes.
  std::vector<PaintCheckpoint> take_kept() { return std::exchange(kept_, {}); }

  static constexpr uint64_t kStrokesPerKeptCheckpoint = 32;

  const History& history() const { return history_; }
  const Fields& fields() const { return fields_; }
  uint64_t byte_count() const { return checkpoints_.byte_count() + history_.byte_count(); }
  /// Strokes painted since this was made, by which a test sees how long replays are.
  uint64_t painted_strokes() const { return painted_strokes_; }

 private:
  /// The entries that count, by what they do.
  struct Counting {
    SetGradientScale slider;
    SetTransferCurve curve;
    std::vector<const History::Entry*> strokes;
    std::vector<const History::Entry*> cells;
  };

  Counting counting() const;
  Status replay(const Progress& progress);
  void replay_cells(const Counting& counting);
  Status replay_strokes(const Counting& counting, const Progress& progress);
  void keep_checkpoint(uint64_t newest);

  History history_;
  Fields fields_;
  Changes changes_{true, true};
  std::vector<uint64_t> cells_done_;    // entries whose cells the fields have, in order
  std::vector<uint64_t> strokes_done_;  // the series of the strokes that the fields have
  PaintCheckpoints checkpoints_;
  std::vector<PaintCheckpoint> kept_;
  uint64_t painted_strokes_ = 0;
};

}  // namespace burnish
