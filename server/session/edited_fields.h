#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "common/base/progress.h"
#include "common/edit/controls.h"
#include "server/fields/fields.h"
#include "server/fields/paint_checkpoints.h"
#include "server/fields/protection.h"
#include "server/session/history.h"
#include "server/session/layer_check.h"

namespace burnish {

/// Adds to a failure which edit of a message it is about. The only edit needs no name.
inline Status about_edit(const Status& status, const Edit& edit, size_t edits) {
  return edits == 1 ? status : status.with_context("edit " + edit.id);
}

/// The history of a session and the fields that it makes. Every change works in the same way,
/// whether a new edit, an undo, a late join, a recovery or a fork: the history changes first, then
/// a replay applies the entries that are on and not yet in the fields. The fields depend on the
/// order of the edits alone, not on their batches, nor on the pauses of a replay.
class EditedFields {
 public:
  /// Needs: prepared outlives this.
  /// `initial` counts until an edit sets others.
  explicit EditedFields(const PreparedMesh& prepared, const Controls& initial = {});

  /// Takes all edits or none into the history, which is quick. The fields are behind until they
  /// catch up. Returns the number that History::apply gives for each. Needs: ids that the history
  /// does not know. Fails: as validate() and History::apply() do, and for a cell that is not
  /// active; names the edit.
  Result<std::vector<uint64_t>> record(std::span<const AuthoredEdit> edits);

  /// Returns whether the history has something that the fields do not have yet.
  bool is_behind() const { return is_behind_; }

  /// Brings the fields up to the history. Fails: cancelled; the next call continues there.
  Status catch_up(const Progress& progress = {});

  /// Does both: all edits or none. Fails: as both; cancelled.
  Result<std::vector<uint64_t>> apply(std::span<const AuthoredEdit> edits,
                                      const Progress& progress = {});

  /// Takes the edits of an earlier session into the empty history. Damaged edits, and edits that
  /// are refused today, are skipped and keep their numbers. Returns how many have no effect any
  /// more.
  uint64_t restore(std::span<const AuthoredEdit> edits);

  /// Checks a new edit against the mesh; apply() is less strict because it takes older histories.
  /// Fails: invalid_argument for a cell that is not active or set twice, and for a stroke that
  /// touches no cell; failed_precondition for a volume to keep of a scan that is not closed, and
  /// for a stroke whose cells are all protected.
  Status check_new(const Edit& edit) const;

  /// Returns what checks new edits against the bands and the palette of the history.
  LayerCheck layers() const;

  /// The changes since the last take_changes().
  const EditEffects& changes() const { return changes_; }
  EditEffects take_changes() { return std::exchange(changes_, {}); }

  /// Lets a later replay begin at a checkpoint that was kept elsewhere.
  void offer(PaintCheckpoint checkpoint) { checkpoints_.add(std::move(checkpoint)); }

  /// Returns the checkpoints since the last call that are worth keeping elsewhere. They bound a
  /// replay to kStrokesPerKeptCheckpoint strokes.
  std::vector<PaintCheckpoint> take_kept() { return std::exchange(kept_, {}); }

  static constexpr uint64_t kStrokesPerKeptCheckpoint = 32;

  const History& history() const { return history_; }
  const Fields& fields() const { return fields_; }
  const Controls& controls() const { return fields_.settings().controls; }
  /// Returns the rims while the controls pin them, though none may be held; else null.
  std::shared_ptr<const HeldRims> pinned_rims() const {
    return controls().pin_rims ? rims_ : nullptr;
  }
  /// Returns the protected region; not of one moment while this is behind.
  const Protection& protection() const { return protection_; }
  uint64_t byte_count() const { return checkpoints_.byte_count() + history_.byte_count(); }
  /// Returns the strokes painted since this was made. Tests check with it how long replays are.
  uint64_t painted_strokes() const { return painted_strokes_; }

 private:
  /// The entries that count, by what they change. Cells that paint kept edges are strokes.
  struct Counting {
    Settings settings;
    std::vector<const History::Entry*> protects;
    std::vector<const History::Entry*> strokes;
    bool paints_edges = false;            ///< one of the strokes does
    std::vector<size_t> protects_before;  ///< of each stroke: so many of `protects`
    std::vector<const History::Entry*> cells;
  };

  /// A stroke in the middle of a replay.
  struct Begun {
    uint64_t series;  ///< ends with this stroke
    std::vector<Vec3d> centres;
    std::vector<int64_t> cells;  ///< cells that the stroke may reach
    size_t painted_cells = 0;
    std::optional<ConnectedDabs> dabs;  ///< of a connected brush, in place of the above
  };

  Status check(const Edit& edit) const;
  Status check_new(const Stroke& stroke) const;
  Counting counting() const;
  static std::vector<uint64_t> series_of(const Counting& counting, uint64_t begin);
  void set(const Settings& settings);
  void protect_by(std::span<const History::Entry* const> entries);
  bool replay_protects(const Counting& counting);
  void hold_region();
  void hold_rims();
  void replay_cells(const Counting& counting);
  Status replay_strokes(const Counting& counting, const Progress& progress);
  Status paint_strokes(const Counting& counting, const std::vector<uint64_t>& series,
                       const Progress& progress);
  void go_back_to_shared(const std::vector<uint64_t>& series);
  Status paint(const Change& change, uint64_t series, const Progress& progress, double done);
  Status paint(const Stroke& stroke, uint64_t series, const Progress& progress, double done);
  void begin(const Stroke& stroke, uint64_t series);
  bool paint_on(const Brush& brush);
  void keep_checkpoint(uint64_t newest);

  const PreparedMesh& prepared_;
  History history_;
  Fields fields_;
  const Controls initial_;
  std::shared_ptr<const HeldRims> rims_;  // found when rims are first pinned
  Protection protection_;
  std::vector<uint64_t> protects_applied_;  // entries that protection_ has, in order
  std::vector<uint64_t> protects_done_;     // entries whose cells are held, in order
  EditEffects changes_{true, true};
  std::vector<uint64_t> cells_done_;    // entries whose cells the fields have, in order
  std::vector<uint64_t> strokes_done_;  // series of the strokes that the fields have
  std::optional<Begun> begun_;          // one more stroke, with some of its cells in the fields
  bool is_behind_ = false;
  PaintCheckpoints checkpoints_;
  std::vector<PaintCheckpoint> kept_;
  uint64_t painted_strokes_ = 0;
};

}  // namespace burnish
