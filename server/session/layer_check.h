#pragma once

#include "common/edit/edit.h"

namespace burnish {

/// The bands and the curves that a session has, to check new edits in their order: one of them may
/// set what the next one paints.
class LayerCheck {
 public:
  LayerCheck(const Equaliser& equaliser, Palette palette, TransferCurve curve)
      : bands_(equaliser.bands.size()), palette_(std::move(palette)), curve_(std::move(curve)) {}

  /// Checks the next edit, and takes it as made. Fails: failed_precondition if its brush paints a
  /// band or a curve that is not there; invalid_argument as check_beside() does.
  Status take(const Edit& edit);

 private:
  Status check(const Edit& edit) const;
  Status check_brush(const Brush& brush) const;

  size_t bands_;
  Palette palette_;
  TransferCurve curve_;
  bool is_known_ = true;  // not after an undo: then nothing is refused
};

}  // namespace burnish
