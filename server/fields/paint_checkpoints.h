#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "common/base/status.h"
#include "common/edit/brush.h"
#include "server/fields/fields.h"
#include "server/prepare/prepared_mesh.h"

namespace burnish {

/// What a series of strokes left on the cells. `series` is a hash over the prepared mesh's cells
/// and the content of every stroke, in order: equal series have equal paint.
struct PaintCheckpoint {
  uint64_t series = 0;
  uint64_t strokes = 0;
  PaintedCells painted;
};

/// The hash of no strokes.
uint64_t begin_series(const PreparedMesh& prepared);
/// The hash of `series` and one more stroke, `stroke_hash` being hash_of(stroke).
uint64_t extend_series(uint64_t series, uint64_t stroke_hash);
uint64_t hash_of(const Stroke& stroke);

/// Paint along the way of a session's strokes, so that a replay begins near its end: dense close to
/// the newest stroke, thinner the further back. Only a shortcut: whatever is missing is replayed.
class PaintCheckpoints {
 public:
  /// False: a checkpoint after so many strokes would be dropped when `newest` have been painted.
  static bool is_worth_keeping(uint64_t strokes, uint64_t newest);

  /// Adds one, and drops those that are not worth keeping any more.
  void add(PaintCheckpoint checkpoint);

  /// The checkpoint that lies furthest along `series` (the hash after each stroke, the first one of
  /// none) and after more than `strokes_min` strokes; null when there is none.
  const PaintCheckpoint* find(std::span<const uint64_t> series, size_t strokes_min) const;

  uint64_t byte_count() const;

 private:
  std::vector<PaintCheckpoint> checkpoints_;  // the oldest first
};

/// As the journal keeps the painted cells.
std::string painted_to_bytes(const PaintedCells& painted);
/// Fails: data_loss when the bytes are damaged or name cells beyond `cell_count`.
Result<PaintedCells> painted_from_bytes(std::string_view bytes, size_t cell_count);

}  // namespace burnish
