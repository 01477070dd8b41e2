#pragma once

#include "common/wire/bands_wire.h"
#include "common/wire/edit_wire.h"
#include "common/wire/protect_wire.h"

namespace burnish {

/// Sets the member of the oneof of a message that can have the change: Edit or Preview.
template <typename Message>
struct ChangeWriter {
  Message& message;

  void operator()(const SetGradientScale& change) const {
    message.mutable_gradient_scale()->set_beta(change.beta);
  }
  void operator()(const SetTransferCurve& change) const {
    *message.mutable_transfer_curve() = to_wire(change.curve);
  }
  void operator()(const Stroke& stroke) const { *message.mutable_stroke() = to_wire(stroke); }
  void operator()(const SetCellFields& change) const {
    *message.mutable_cell_fields() = to_wire(change, 0, change.cells.size());
  }
  void operator()(const SetControls& change) const {
    *message.mutable_controls() = to_wire(change.controls);
  }
  void operator()(const Protect& change) const { *message.mutable_protect() = to_wire(change); }
  void operator()(const SetEqualiser& change) const {
    *message.mutable_equaliser() = to_wire(change.equaliser);
  }
  void operator()(const SetPalette& change) const {
    *message.mutable_palette() = to_wire(change.palette);
  }
  void operator()(const SetColour& change) const {
    *message.mutable_colour() = to_wire(change.filter);
  }
  void operator()(const SetEdges& change) const {
    *message.mutable_edges() = to_wire(change.filter);
  }
  void operator()(const Undo&) const { message.mutable_undo(); }
  void operator()(const Redo&) const { message.mutable_redo(); }
  void operator()(const SwitchEntry& change) const {
    message.mutable_switch_entry()->set_entry(change.entry);
    message.mutable_switch_entry()->set_enabled(change.enabled);
  }
  void operator()(const SetCheckpoint& change) const {
    message.mutable_set_checkpoint()->set_name(change.name);
  }
  void operator()(const RestoreCheckpoint& change) const {
    message.mutable_restore_checkpoint()->set_name(change.name);
  }
  void operator()(const Damaged&) const {}  // no message carries one
};

}  // namespace burnish
