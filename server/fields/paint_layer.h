#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "common/base/limits.h"
#include "common/edit/edit.h"

namespace burnish {

/// Paint of one kind: how much of it covers each cell, and its value there.
struct PaintLayer {
  explicit PaintLayer(size_t cells) : value(cells, 0), weight(cells, 0) {}

  /// Blends `painted` over the paint of a cell, of which the fraction `left` shows through.
  void blend(size_t cell, double left, double painted) {
    const double under = weight[cell] * left, covered = under + (1 - left);
    value[cell] = static_cast<float>((value[cell] * under + painted * (1 - left)) / covered);
    weight[cell] = static_cast<float>(covered);
  }
  uint64_t byte_count() const { return (value.size() + weight.size()) * sizeof(float); }

  std::vector<float> value, weight;  ///< per cell; the value counts where the weight is above 0
};

/// The kinds of paint: β, the gain of each band, where each curve of the palette rules, β of the
/// colours, the strength of kept edges, the texture gain.
inline constexpr size_t kBetaLayer = 0;
inline constexpr size_t kFirstBandLayer = 1;
inline constexpr size_t kFirstCurveLayer = kFirstBandLayer + kBandsMax;
inline constexpr size_t kColourLayer = kFirstCurveLayer + kPaletteCurvesMax;
inline constexpr size_t kEdgesLayer = kColourLayer + 1;
inline constexpr size_t kTextureLayer = kEdgesLayer + 1;
inline constexpr size_t kPaintLayers = kTextureLayer + 1;

inline size_t layer_of(const Brush& brush) {
  if (brush.band > 0) return kFirstBandLayer + static_cast<size_t>(brush.band) - 1;
  if (brush.curve > 0) return kFirstCurveLayer + static_cast<size_t>(brush.curve) - 1;
  if (brush.edges) return kEdgesLayer;
  if (brush.texture) return kTextureLayer;
  return brush.colour ? kColourLayer : kBetaLayer;
}

/// Returns the layer that edits of single cells paint, nothing for cells that are not paint.
inline std::optional<size_t> layer_of(CellTarget target) {
  if (target == CellTarget::kEdges) return kEdgesLayer;
  return target == CellTarget::kTexture ? std::optional(kTextureLayer) : std::nullopt;
}

/// Returns the layer that an edit paints, nothing if it paints none.
inline std::optional<size_t> painted_layer(const Change& change) {
  if (const auto* stroke = std::get_if<Stroke>(&change)) return layer_of(stroke->brush);
  const auto* cells = std::get_if<SetCellFields>(&change);
  return cells && !cells->cells.empty() ? layer_of(cells->target) : std::nullopt;
}

/// Painted cells of all layers.
struct PaintedCells {
  std::vector<int32_t> cells;  ///< indices, rising in each layer
  std::vector<float> value, weight;
  std::vector<uint8_t> layer;  ///< of each, rising; empty: all are of kBetaLayer
  bool operator==(const PaintedCells&) const = default;
};

}  // namespace burnish
