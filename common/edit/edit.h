#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "common/base/limits.h"
#include "common/edit/brush.h"
#include "common/edit/colour_filter.h"
#include "common/edit/controls.h"
#include "common/edit/edge_filter.h"
#include "common/edit/equaliser.h"
#include "common/edit/palette.h"
#include "common/edit/protect.h"
#include "common/edit/texture_filter.h"
#include "common/edit/transfer_curve.h"

namespace burnish {

/// Sets β of all cells that are not painted. The last such edit counts.
struct SetGradientScale {
  double beta = kBetaDefault;
};

/// Sets α as a function of curvature; a constant curve is the isotropic fidelity weight. The last
/// such edit counts.
struct SetTransferCurve {
  TransferCurve curve{kAlphaDefault};
};

/// The values that an edit of single cells sets.
enum class CellTarget {
  kFields,      ///< α and β, over all paint
  kEdges,       ///< paints the strength of kept edges
  kProtection,  ///< whether the cell is in the protected region
  kTexture,     ///< paints the texture gain
};

/// Sets single cells, as `--cell-field` reads them; other cells keep what they have.
struct SetCellFields {
  struct Cell {
    Vec3i cell;     ///< grid units
    double alpha1;  ///< user units; of kFields alone
    double alpha2;  ///< user units; of kFields alone
    double beta;    ///< of kEdges: the strength, 0 to 1; of kProtection: 1 or 0; of kTexture: the
                    ///< gain, 0 to kTextureGainMax
  };
  std::vector<Cell> cells;
  CellTarget target = CellTarget::kFields;
};

/// Sets the bounds on what all edits do. The last such edit counts.
struct SetControls {
  Controls controls;
};

/// Sets the bands and their gains. The last such edit counts.
struct SetEqualiser {
  Equaliser equaliser;
};

/// Sets the curves that brushes paint. The last such edit counts.
struct SetPalette {
  Palette palette;
};

/// Sets the filter of the scan's colours. The last such edit counts.
struct SetColour {
  ColourFilter filter;
};

/// Says how edges are kept and noise is found. The last such edit counts.
struct SetEdges {
  EdgeFilter filter;
};

/// Sets the gain of the texture and the removed light. The last such edit counts.
struct SetTexture {
  TextureFilter filter;
};

/// Switches off the author's newest entry that is on.
struct Undo {};

/// Switches on the entry that the author's last undo switched off. After a new change nothing can
/// be redone.
struct Redo {};

/// Switches an entry of the history off or on, whoever its author is.
struct SwitchEntry {
  uint64_t entry = 0;  ///< its number
  bool enabled = false;
};

/// Names the current state of the session. The last use of a name counts.
struct SetCheckpoint {
  std::string name;
};

/// Switches every entry to its state at the checkpoint; later entries are off.
struct RestoreCheckpoint {
  std::string name;
};

/// Replaces a stored edit that cannot be read. It keeps the edit's number and changes nothing; its
/// author's undo counts it. Nobody can send one.
struct Damaged {
  std::string reason;
};

using Change = std::variant<SetGradientScale, SetTransferCurve, Stroke, SetCellFields, SetControls,
                            Protect, SetEqualiser, SetPalette, SetColour, SetEdges, SetTexture,
                            Undo, Redo, SwitchEntry, SetCheckpoint, RestoreCheckpoint, Damaged>;

/// One change of a session. The client chooses the id; applying an id twice is harmless.
struct Edit {
  std::string id;
  Change change;
};

/// A change that a gesture shows before it is an edit.
using PreviewChange = std::variant<SetGradientScale, SetTransferCurve, Stroke, SetEqualiser,
                                   SetPalette, SetColour, SetEdges, SetTexture>;

/// The values that the last edit of each kind sets for a whole session.
struct Settings {
  double beta = kBetaDefault;  ///< of cells that are not painted
  TransferCurve curve{kAlphaDefault};
  Controls controls;
  Equaliser equaliser;
  Palette palette;
  ColourFilter colour;
  EdgeFilter edges;
  TextureFilter texture;
  bool operator==(const Settings&) const = default;

  /// Takes what the change sets. Edits of places, and of which edits count, set nothing here.
  void take(const Change& change);
  void take(const PreviewChange& change);
};

/// The effects of an edit, in the terms of the solver.
struct EditEffects {
  bool metric = false;  ///< α1, α2: new matrices
  bool beta = false;    ///< only a new constraint
  bool shown = false;   ///< nothing for the solver: what is shown of its result

  bool any() const { return metric || beta || shown; }
  EditEffects& operator|=(const EditEffects& other) {
    metric |= other.metric;
    beta |= other.beta;
    shown |= other.shown;
    return *this;
  }
};

/// Returns what a gesture changes.
EditEffects effects_of(const PreviewChange& gesture);
/// Returns what setting others changes.
EditEffects effects_between(const Settings& before, const Settings& after);

/// Returns one change for each of the settings, in the order of EditKind. Together they make them.
std::vector<Change> changes_that_make(const Settings& settings);

/// One of the settings for people.
struct SettingText {
  const char* key;    ///< in the processing record: "transfer_curve"
  const char* label;  ///< "Transfer curve α(κ)"
  std::string text;   ///< "0:50"
};
/// Returns a text for each of the settings, in the order of EditKind.
std::vector<SettingText> texts_of(const Settings& settings);

/// In the order of Change. edit_kinds.cpp has a row for each.
enum class EditKind {
  kGradientScale,
  kTransferCurve,
  kStroke,
  kCellFields,
  kControls,
  kProtect,
  kEqualiser,
  kPalette,
  kColour,
  kEdges,
  kTexture,
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

/// Returns true for edits that fields are made of. The other kinds only say which of these count.
bool makes_fields(EditKind kind);

/// Returns whether only a scan with colours can have the change.
bool needs_colours(const Change& change);

/// Returns the number of the kind as an entry of the history, which the protocol's EntryKind has
/// too; 0 for edits that only switch entries. A number is never used again.
int entry_number(EditKind kind);
/// Returns the kind with this number, nothing for another number.
std::optional<EditKind> kind_of_entry(int number);

/// "slider", "curve", "stroke", "cells", "controls", "protect", "equaliser", "palette",
/// "colour", "edges", "texture", "undo", "redo", "switch", "checkpoint", "restore", "damaged".
const char* edit_kind_name(EditKind kind);

/// Describes the edit in a few words: "beta 0.25", "stroke of 12 points, radius 0.5, beta 2".
std::string summary(const Edit& edit);

/// An edit as a session keeps it. Ids are unique among one author's edits.
struct AuthoredEdit {
  std::string author;  ///< empty: a user without a name
  int64_t unix_ms = 0;
  Edit edit;
};

/// Checks every value against its limit, as far as possible without the mesh and the history.
/// Fails: invalid_argument; data_loss for a damaged edit.
Status validate(const Edit& edit);

}  // namespace burnish
