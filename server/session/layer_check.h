#pragma once

#include <utility>

#include "common/edit/settings.h"

namespace burnish {

/// Returns the settings without those that do not count beside kept edges: bands, and a volume to
/// keep. An undo can bring both back.
Settings counting_beside_edges(Settings settings);

/// The bands and the curves that a session has, to check new edits in their order: one of them may
/// set what the next one paints.
class LayerCheck {
 public:
  explicit LayerCheck(Settings settings) : settings_(std::move(settings)) {}

  /// Checks the next edit, and takes it as made. Fails: failed_precondition if its brush paints a
  /// band or a curve that is not there, or for what cannot stand beside kept edges;
  /// invalid_argument as check_beside() does.
  Status take(const Edit& edit);

 private:
  Status check(const Edit& edit, const Settings& after) const;
  Status check_brush(const Brush& brush) const;

  Settings settings_;
  bool is_known_ = true;  // not after an undo: then nothing is refused
};

}  // namespace burnish
