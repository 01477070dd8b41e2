#include "server/manager/layer_need.h"

#include <algorithm>

#include "server/fields/fields_view.h"
#include "server/memory/memory_need.h"
#include "server/session/baked_light.h"
#include "server/session/edge_parts.h"
#include "server/session/fit_signal.h"
#include "server/session/mesh_signal.h"

namespace burnish {

static constexpr uint64_t kCopies = 2;  // of the fields: a gesture has its own
static constexpr uint64_t kPaintBytesPerCell = 2 * sizeof(float);
static constexpr uint64_t kGainBytesPerCorner = 2 * sizeof(float);

void LayerNeed::add(std::span<const AuthoredEdit> edits) {
  for (const AuthoredEdit& edit : edits) {
    if (const auto* change = std::get_if<SetEqualiser>(&edit.edit.change))
      bands_ = std::max(bands_, change->equaliser.bands.size());
    edits_colours_ |= std::holds_alternative<SetColour>(edit.edit.change);
    edits_texture_ |= std::holds_alternative<SetTexture>(edit.edit.change);
    if (const auto* change = std::get_if<SetEdges>(&edit.edit.change))
      keeps_edges_ |= change->filter.is_on();
    if (const auto layer = painted_layer(edit.edit.change)) {
      painted_.set(*layer);
      keeps_edges_ |= *layer == kEdgesLayer;
    }
  }
}

uint64_t LayerNeed::byte_count(const Multigrid& on) const {
  const SparseGrid& grid = on.hierarchy->at(on.hierarchy->finest).grid;
  const uint64_t corners = grid.corners.size(), cells = grid.cells.size();
  uint64_t bytes = 0;
  // The solver of the surfaces behind the bands, these surfaces, and their sum.
  if (bands_ > 0) bytes += predict_session_bytes(on) + (bands_ + 1) * corners * sizeof(Vec3f);
  // A solver for the colours, its signal, its fields, the fit at its beginning, and the triangles.
  if (edits_colours_ || painted_[kColourLayer])
    bytes += predict_session_bytes(on) + 2 * corners * sizeof(Vec3f) + 3 * cells * sizeof(float) +
             predict_fit_bytes(on) + predict_mesh_signal_bytes(*on.prepared);
  if (edits_texture_) bytes += predict_fit_bytes(on) + predict_light_bytes(on);
  if (painted_[kTextureLayer]) bytes += predict_fit_bytes(on) + cells * sizeof(float);
  if (keeps_edges_) bytes += predict_edge_bytes(on);
  bool has_curves = false;
  for (size_t layer = kFirstBandLayer; layer < kPaintLayers; ++layer) {
    if (!painted_[layer]) continue;
    bytes += kCopies * cells * kPaintBytesPerCell;
    if (layer < kFirstCurveLayer) bytes += corners * kGainBytesPerCorner;
    has_curves |= layer >= kFirstCurveLayer && layer < kColourLayer;
  }
  return bytes + (has_curves ? kCopies * cells * sizeof(OwnFields) : 0);
}

}  // namespace burnish
