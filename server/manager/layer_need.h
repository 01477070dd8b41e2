#pragma once

#include <bitset>
#include <cstdint>
#include <span>

#include "common/edit/edit.h"
#include "server/fields/paint_layer.h"
#include "server/solver/cycle/multigrid.h"

namespace burnish {

/// Memory that the edits of a session take beside predict_session_bytes(): bands, colours,
/// kept edges, and paint of other kinds than β. Edits that are off count too, because undo can
/// bring them back.
class LayerNeed {
 public:
  void add(std::span<const AuthoredEdit> edits);

  /// Accuracy: no less than it takes on the CPU backend.
  uint64_t byte_count(const Multigrid& on) const;

 private:
  bool edits_colours_ = false, edits_texture_ = false, keeps_edges_ = false;
  size_t bands_ = 0;  // the most that an edit sets
  std::bitset<kPaintLayers> painted_;
};

}  // namespace burnish
