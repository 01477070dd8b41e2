#include "common/denoise/normal_layer.h"

#include <algorithm>
#include <cmath>

#include "common/denoise/filter_constants.h"
#include "common/denoise/heard_blocks.h"
#include "common/denoise/layer_steps.h"
#include "common/denoise/mean_side.h"

namespace burnish {
namespace {

/// The arrays of a LayerField.
class Layer {
 public:
  Layer(const WeldedSurface& surface, std::span<const NormalAndArea> normals,
        const ScratchSpace& space, const LoopPart& part)
      : surface_(surface),
        unit_(mean_side(surface, part.of(0, 0.3))),
        moves_(space, surface.vertex_count()),
        planes_(space, surface.triangle_count()),
        offsets_(space, surface.incidence_count()) {
    parallel_for_heard(part.of(0.3, 0.8), moves_.size(), [&](size_t v) { begin_at(v, normals); });
    parallel_for_heard(part.of(0.8, 1), planes_.size(), [&](size_t t) {
      planes_[t] = normals[t] * std::sqrt(normals[t][3]);
      planes_[t][3] = 0;
    });
  }

  void update(const LoopPart& part) {
    const LayerField field = {surface_.triangles().data(),
                              surface_.fan_starts(),
                              surface_.fans(),
                              offsets_.data(),
                              planes_.data(),
                              moves_.data()};
    for_each_block_heard(part.of(0, 0.4), planes_.size(),
                         [&](size_t begin, size_t end) { measure_centres(field, begin, end); });
    for_each_block_heard(part.of(0.4, 1), moves_.size(),
                         [&](size_t begin, size_t end) { pull_places(field, begin, end); });
  }

  /// Returns the move of a place, file units.
  Vec3d move(size_t place) const { return normal_of(moves_[place]) * unit_; }

 private:
  void begin_at(size_t v, std::span<const NormalAndArea> normals) {
    float area = 0;
    uint64_t i = surface_.fan_starts()[v];
    const Vec3d& place = surface_.mesh().vertices[v];
    for (const uint32_t t : surface_.fan(v)) {
      const auto [a, b, c] = corners_of(surface_.mesh(), t);
      const Vec3d to_centre = ((a - place) + (b - place) + (c - place)) / (3 * unit_);
      const auto height = static_cast<float>(normal_of(normals[t]).dot(to_centre));
      offsets_[i++] = height * std::sqrt(normals[t][3]);
      area += normals[t][3];
    }
    moves_[v] = Float4{0, 0, 0, area > kPlaceAreaMin ? 1 / area : 0};
  }

  const WeldedSurface& surface_;
  const double unit_;
  ScratchArray<Float4> moves_, planes_;
  ScratchArray<float> offsets_;
};

Vec3f capped(const Vec3d& way, double cap) {
  const double length = way.norm();
  return (length > cap ? Vec3d(way * (cap / length)) : way).cast<float>();
}

bool has_turned(const WeldedSurface& surface, const std::vector<Vec3f>& moves, size_t t) {
  if (!surface.is_surface(t)) return false;
  const auto [a, b, c] = corners_of(surface.mesh(), t);
  const auto move = [&](int corner) {
    return Vec3d(moves[surface.triangle(t)[corner]].cast<double>());
  };
  const Vec3d ab = b - a, ac = c - a;
  return ab.cross(ac).dot((ab + move(1) - move(0)).cross(ac + move(2) - move(0))) < 0;
}

/// Lets the corners of triangles that have turned stay. Returns whether there were any.
bool keep_turned(const WeldedSurface& surface, std::vector<Vec3f>& moves,
                 ScratchArray<uint8_t>& turned, const LoopPart& part) {
  parallel_for_heard(part.of(0, 0.5), surface.triangle_count(),
                     [&](size_t t) { turned[t] = has_turned(surface, moves, t); });
  if (std::ranges::none_of(turned, [](uint8_t is) { return is != 0; })) return false;
  const auto is_turned = [&](uint32_t t) { return turned[t] != 0; };
  parallel_for_heard(part.of(0.5, 1), surface.vertex_count(), [&](size_t v) {
    if (std::ranges::any_of(surface.fan(v), is_turned)) moves[v] = Vec3f::Zero();
  });
  return true;
}

void guard(const WeldedSurface& surface, std::vector<Vec3f>& moves, const ScratchSpace& space,
           const LoopPart& part) {
  ScratchArray<uint8_t> turned(space, surface.triangle_count());
  for (double round = 0; round < kGuardRounds; ++round)
    if (!keep_turned(surface, moves, turned,
                     part.of(round / kGuardRounds, (round + 1) / kGuardRounds)))
      return;
}

/// Gives vertices the moves of their places.
void share_moves(const WeldedSurface& surface, std::vector<Vec3f>& moves, const LoopPart& part) {
  parallel_for_heard(part, moves.size(), [&](size_t v) {
    if (surface.place(v) != v) moves[v] = moves[surface.place(v)];
  });
}

}  // namespace

std::vector<Vec3f> normal_layer(const WeldedSurface& surface,
                                std::span<const NormalAndArea> normals, const LayerOptions& options,
                                const ScratchSpace& space, const LoopPart& part) {
  Layer layer(surface, normals, space, part.of(0, 0.1));
  const LoopPart updates = part.of(0.1, 0.8);
  for (double i = 0; i < options.updates; ++i)
    layer.update(updates.of(i / options.updates, (i + 1) / options.updates));
  std::vector<Vec3f> moves(surface.vertex_count());
  parallel_for_heard(part.of(0.8, 0.85), moves.size(),
                     [&](size_t v) { moves[v] = capped(layer.move(v), options.cap); });
  guard(surface, moves, space, part.of(0.85, 0.97));
  share_moves(surface, moves, part.of(0.97, 1));
  return moves;
}

}  // namespace burnish
