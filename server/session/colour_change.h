#pragma once

#include <span>
#include <vector>

#include "common/edit/texture_filter.h"
#include "common/evaluation/evaluation.h"
#include "server/session/baked_light.h"

namespace burnish {

/// The texture filter over the surface.
struct TextureChange {
  TextureFilter filter;
  std::span<const CornerNumber> light;  ///< find_baked_light(); empty: no light goes
  std::span<const float> held;          ///< per cell: how much stays as it is; empty: nothing
  std::span<const float> gains;         ///< per cell, in place of the filter's; empty: no paint

  bool is_there() const { return filter.changes_colours() || !gains.empty(); }
  float gain(int32_t cell) const {
    return gains.empty() ? static_cast<float>(filter.gain) : gains[cell];
  }
};

/// A change of colour on the grid and what it leaves of details that are finer than a cell. At a
/// point of colour f the change is that of the grid, plus the cell's share times f less the fitted
/// colour. The texture filter follows.
struct ColourChange {
  std::span<const Vec3f> on_grid;  ///< per corner; empty: the filter of colours keeps them
  std::span<const Vec3f> fitted;   ///< per corner: the grid's nearest to the scan's colours
  std::span<const float> share;    ///< per cell, of the last solve on triangles; empty before it
  TextureChange texture = {};

  bool is_there() const { return !on_grid.empty() || texture.is_there(); }
};

/// Says how much of the seams of a scan's pictures is levelled: in exports, and in sheets.
struct SeamLevelling {
  double amount = 0;        ///< 0 to 1
  std::vector<float> free;  ///< per vertex, 0 to 1: how much of it may change; empty: all
};

/// The change at a point: of its colour, and how often texels around differ from it as much.
struct PointChange {
  Vec3f colour = Vec3f::Zero();  ///< linear light; the sum may be below black or above white
  float gain = 1;
};

/// Returns the change at a point of this colour.
PointChange change_at(const ColourChange& change, const SparseGrid& grid, const EvaluationPoint& at,
                      Rgba8 colour);

/// Returns what the texture filter makes of a colour's change by the filter of colours.
PointChange with_texture(const ColourChange& change, const SparseGrid& grid,
                         const EvaluationPoint& at, Rgba8 colour, const Vec3f& filtered);

}  // namespace burnish
