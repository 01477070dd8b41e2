#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "common/base/status.h"
#include "common/edit/edit.h"
#include "server/fields/paint_layer.h"
#include "server/prepare/prepared_mesh.h"

namespace burnish {

/// The paint on the cells after a series of strokes. `series` is a hash over the prepared mesh's
/// cells and the content of every stroke, in order: equal series have equal paint.
struct PaintCheckpoint {
  uint64_t series = 0;
  uint64_t strokes = 0;
  PaintedCells painted;
};

/// Returns the hash of no strokes.
uint64_t begin_series(const PreparedMesh& prepared);
/// Returns the hash of `series` and one more stroke. `stroke_hash` is that of its content.
uint64_t extend_series(uint64_t series, uint64_t stroke_hash);
uint64_t hash_of(const Stroke& stroke);
/// Returns the hash of cells that paint kept edges, which counts as a stroke.
uint64_t hash_of(const SetCellFields& cells);

/// Paint after some of a session's strokes, so that a replay begins near its end. Checkpoints are
/// dense close to the newest stroke and thinner further back. They are only a shortcut: a replay
/// makes missing ones again.
class PaintCheckpoints {
 public:
  /// Returns false if add() would drop a checkpoint after `strokes` strokes once `newest` are
  /// painted.
  static bool is_worth_keeping(uint64_t strokes, uint64_t newest);

  /// Adds a checkpoint, and drops those that are no longer worth keeping.
  void add(PaintCheckpoint checkpoint);

  /// Returns the checkpoint furthest along `series` (the hash after each stroke, first of none) and
  /// after more than `strokes_min` strokes; null if there is none.
  const PaintCheckpoint* find(std::span<const uint64_t> series, size_t strokes_min) const;

  uint64_t byte_count() const;

 private:
  std::vector<PaintCheckpoint> checkpoints_;  // the oldest first
};

/// Returns the painted cells in the journal's form.
std::string painted_to_bytes(const PaintedCells& painted);
/// Fails: data_loss if the bytes are damaged or name cells beyond `cell_count`.
Result<PaintedCells> painted_from_bytes(std::string_view bytes, size_t cell_count);

}  // namespace burnish
