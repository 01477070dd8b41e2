#include "common/frame_codec/frame_layout.h"

#include <cmath>
#include <xxhash.h>

#include "common/base/parallel.h"

namespace burnish {

namespace {

// Measured on scans: a vertex takes about as many bytes as 1.5 coefficients, because it has no grid
// neighbours to predict it.
constexpr double kVertexCost = 1.5;

constexpr int kSlackExponentMax = 14;

std::vector<float> largest_weights(const FrameMesh& mesh) {
  std::vector<float> largest(mesh.grid.corners.size(), 0);
  for (const EvaluationPoint& point : mesh.points) {
    if (point.cell == kNone) continue;
    const auto weights = trilinear_weights(point.local);
    for (int a = 0; a < kCornersPerCell; ++a) {
      float& so_far = largest[mesh.grid.cell_corners[point.cell][a]];
      so_far = std::max(so_far, weights[a]);
    }
  }
  return largest;
}

// The eight corners of a cell weigh on a vertex together: each may add an eighth.
uint16_t slack_of(float largest_weight) {
  const int exponent = -std::ilogb(8 * largest_weight) - 1;
  return static_cast<uint16_t>(1 << std::clamp(exponent, 0, kSlackExponentMax));
}

// Finds the values of one tile by their place; places are rising.
class TilePlaces {
 public:
  explicit TilePlaces(std::span<const MortonKey> places) : places_(places) {}

  /// Returns the place in the tile of the corner `back` cells below value `i`, else kTileValues.
  uint16_t behind(int i, const Vec3i& back) const {
    const Vec3i point = morton_point(places_[i]) - back;
    if (point.minCoeff() < 0) return kTileValues;
    const auto end = places_.begin() + i;
    const auto it = std::lower_bound(places_.begin(), end, morton_key(point));
    if (it == end || *it != morton_key(point)) return kTileValues;
    return static_cast<uint16_t>(it - places_.begin());
  }

 private:
  std::span<const MortonKey> places_;
};

Predictor previous(int i) {
  return {static_cast<uint16_t>(i > 0 ? i - 1 : kTileValues), kTileValues, kTileValues};
}

// Predicts by the plane through three neighbours of a square, else by one neighbour, else by the
// value before.
Predictor predictor_in_grid(const TilePlaces& places, int i) {
  std::array<uint16_t, 3> along;
  for (int axis = 0; axis < 3; ++axis) along[axis] = places.behind(i, Vec3i::Unit(axis));
  for (int skipped = 2; skipped >= 0; --skipped) {
    const uint16_t a = along[skipped == 0 ? 1 : 0];
    const uint16_t b = along[skipped == 2 ? 1 : 2];
    if (a == kTileValues || b == kTileValues) continue;
    const uint16_t c = places.behind(i, Vec3i::Ones() - Vec3i::Unit(skipped));
    if (c != kTileValues) return {a, b, c};
  }
  for (const uint16_t neighbour : along)
    if (neighbour != kTileValues) return {neighbour, kTileValues, kTileValues};
  return previous(i);
}

uint64_t fingerprint_of(const FrameLayout& layout) {
  const auto add = [](uint64_t seed, const auto& values) {
    return XXH3_64bits_withSeed(values.data(), values.size() * sizeof(values[0]), seed);
  };
  return add(add(static_cast<uint64_t>(layout.content), layout.source), layout.predictors);
}

// Orders vertices by cell, then by Morton order within the cell, then by number.
struct VertexPlace {
  uint64_t place;
  int32_t vertex;
  auto operator<=>(const VertexPlace&) const = default;
};

VertexPlace place_of(const EvaluationPoint& point, int32_t vertex) {
  Vec3i within;
  for (int axis = 0; axis < 3; ++axis)
    within[axis] = std::min(static_cast<int>(point.local[axis] * 256), 255);
  return {static_cast<uint64_t>(point.cell) << 24 | morton_key(within), vertex};
}

}  // namespace

uint64_t FrameLayout::byte_count() const {
  return source.size() * (sizeof(source[0]) + sizeof(predictors[0]) + sizeof(slack[0]));
}

FrameLayout make_coefficient_layout(const FrameMesh& mesh) {
  FrameLayout layout{.content = FrameContent::kCoefficients};
  std::vector<MortonKey> places;
  const std::vector<float> largest = largest_weights(mesh);
  for (int32_t corner = 0; corner < mesh.grid.corner_count(); ++corner) {
    if (largest[corner] == 0) continue;
    layout.source.push_back(corner);
    layout.slack.push_back(slack_of(largest[corner]));
    places.push_back(mesh.grid.corners[corner].place);
  }
  layout.predictors.resize(places.size());
#pragma omp parallel for schedule(static)
  for (int tile = 0; tile < layout.tile_count(); ++tile) {
    const int begin = layout.tile_begin(tile);
    const std::span<const MortonKey> tile_places(&places[begin], layout.tile_size(tile));
    const TilePlaces in_tile(tile_places);
    for (int i = 0; i < layout.tile_size(tile); ++i)
      layout.predictors[begin + i] = predictor_in_grid(in_tile, i);
  }
  layout.fingerprint = fingerprint_of(layout);
  return layout;
}

FrameLayout make_vertex_layout(const FrameMesh& mesh) {
  FrameLayout layout{.content = FrameContent::kVertices};
  std::vector<VertexPlace> places;
  for (size_t v = 0; v < mesh.points.size(); ++v)
    if (mesh.points[v].cell != kNone)
      places.push_back(place_of(mesh.points[v], static_cast<int32_t>(v)));
  parallel_sort(places.begin(), places.end(), std::less<>());
  for (const VertexPlace& place : places) layout.source.push_back(place.vertex);
  layout.slack.assign(places.size(), 1);
  for (int i = 0; i < layout.value_count(); ++i)
    layout.predictors.push_back(previous(i % kTileValues));
  layout.fingerprint = fingerprint_of(layout);
  return layout;
}

FrameLayout make_smaller_layout(const FrameMesh& mesh) {
  FrameLayout coefficients = make_coefficient_layout(mesh);
  const auto vertices = std::ranges::count_if(
      mesh.points, [](const EvaluationPoint& point) { return point.cell != kNone; });
  if (kVertexCost * static_cast<double>(vertices) < coefficients.value_count())
    return make_vertex_layout(mesh);
  return coefficients;
}

}  // namespace burnish
