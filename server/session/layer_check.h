#pragma once

#include <utility>

#include "common/edit/edit.h"

namespace burnish {

/// Returns the settings that count. If edges are kept, everywhere or where it is painted, bands do
/// not, nor does a volume to keep: an undo can bring them back.
Settings counting_beside_edges(Settings settings, bool edges_are_painted);

/// The bands and the curves that a session has, to check new edits in their order: one of them may
/// set what the next one paints.
class LayerCheck {
 public:
  LayerCheck(Settings settings, bool edges_are_painted)
      : settings_(std::move(settings)), edges_are_painted_(edges_are_painted) {}

  /// Checks the next edit, and takes it as made. Fails: failed_precondition if its brush paints a
  /// band or a curve that is not there, or for what cannot stand beside kept edges;
  /// invalid_argument as check_beside() does.
  Status take(const Edit& edit);

 private:
  Status check(const Edit& edit, const LayerCheck& after) const;
  Status check_brush(const Brush& brush) const;
  Status check_beside_edges() const;

  Settings settings_;
  bool edges_are_painted_;
  bool is_known_ = true;  // not after an undo: then nothing is refused
};

}  // namespace burnish
