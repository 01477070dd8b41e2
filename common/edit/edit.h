#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "common/base/limits.h"
#include "common/edit/brush.h"
#include "common/edit/transfer_curve.h"

namespace burnish {

/// β everywhere that is not painted. The last one counts.
struct SetGradientScale {
  double beta = kBetaDefault;
};

/// α as a function of curvature; a constant curve is the isotropic fidelity weight. The last one
/// counts.
struct SetTransferCurve {
  TransferCurve curve{kAlphaDefault};
};

/// Overrides of single cells, as `--cell-field` reads them; cells not named keep their fields.
struct SetCellFields {
  struct Cell {
    Vec3i cell;     ///< grid units
    double alpha1;  ///< user units
    double alpha2;  ///< user units
    double beta;
  };
  std::vector<Cell> cells;
};

/// Switches off the author's newest entry that is on.
struct Undo {};

/// Switches on the entry that the author's last undo switched off; a new change ends what can be
/// redone.
struct Redo {};

/// Switches an entry of the history, anybody's, off or on.
struct SwitchEntry {
  uint64_t entry = 0;  ///< its number
  bool enabled = false;
};

/// Names the state that the session has now. The name's last use counts.
struct SetCheckpoint {
  std::string name;
};

/// Switches every entry to what it was at the checkpoint; entries since then are off.
struct RestoreCheckpoint {
  std::string name;
};

/// Stands where a stored edit was that cannot be read any more: it keeps the edit's number, its
/// author's undo counts it, and it changes nothing. Nobody can send one.
struct Damaged {
  std::string reason;
};

/// One change of a session. The id is the client's choice: applying an id twice is harmless.
struct Edit {
  std::string id;
  std::variant<SetGradientScale, SetTransferCurve, Stroke, SetCellFields, Undo, Redo, SwitchEntry,
               SetCheckpoint, RestoreCheckpoint, Damaged>
      change;
};

/// What a gesture shows before it is an edit.
using PreviewChange = std::variant<SetGradientScale, SetTransferCurve, Stroke>;

/// In the order of Edit::change.
enum class EditKind {
  kGradientScale,
  kTransferCurve,
  kStroke,
  kCellFields,
  kUndo,
  kRedo,
  kSwitchEntry,
  kSetCheckpoint,
  kRestoreCheckpoint,
  kDamaged,
};

inline EditKind kind_of(const Edit& edit) {
  return static_cast<EditKind>(edit.change.index());
}

/// True for what fields are made of; the other kinds only say which of those count.
inline bool makes_fields(EditKind kind) {
  return kind <= EditKind::kCellFields;
}

/// "slider", "curve", "stroke", "cells", "undo", "redo", "switch", "checkpoint", "restore",
/// "damaged".
const char* edit_kind_name(EditKind kind);

/// What the edit does, in a few words: "beta 0.25", "stroke of 12 points, radius 0.5, beta 2".
std::string summary(const Edit& edit);

/// An edit as a session keeps it. Ids are unique among one author's edits.
struct AuthoredEdit {
  std::string author;  ///< empty: somebody without a name
  int64_t unix_ms = 0;
  Edit edit;
};

/// What can be wrong without knowing the mesh or the history: every value against its limit.
/// Fails: invalid_argument; data_loss for a damaged edit.
Status validate(const Edit& edit);

}  // namespace burnish
