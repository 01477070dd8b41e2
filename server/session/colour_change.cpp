#include "server/session/colour_change.h"

#include <cmath>

#include "common/mesh/srgb.h"

namespace burnish {

PointChange change_at(const ColourChange& change, const SparseGrid& grid, const EvaluationPoint& at,
                      Rgba8 colour) {
  if (at.cell == kNone) return {};
  Vec3f filtered = Vec3f::Zero();
  if (!change.on_grid.empty()) filtered = evaluate(grid, at, change.on_grid);
  if (!change.share.empty())
    filtered += change.share[at.cell] * (linear_colour(colour) - evaluate(grid, at, change.fitted));
  return with_texture(change, grid, at, colour, filtered);
}

PointChange with_texture(const ColourChange& change, const SparseGrid& grid,
                         const EvaluationPoint& at, Rgba8 colour, const Vec3f& filtered) {
  const TextureChange& texture = change.texture;
  if (at.cell == kNone || !texture.is_there()) return {filtered, 1};
  const float left = texture.held.empty() ? 1 : 1 - texture.held[at.cell];
  const float gain = 1 + left * (texture.gain(at.cell) - 1);
  const auto removed = left * static_cast<float>(texture.filter.remove_light);
  const float light =
      texture.light.empty() ? 1 : std::exp(removed * evaluate(grid, at, texture.light)(0));
  const Vec3f before = linear_colour(colour);
  const Vec3f detail = before - evaluate(grid, at, change.fitted);
  return {light * (before + filtered + (gain - 1) * detail) - before, light * gain};
}

}  // namespace burnish
