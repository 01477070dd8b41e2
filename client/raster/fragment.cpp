#include "client/raster/fragment.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "client/raster/shade_math.h"
#include "client/raster/texel_colour.h"

namespace burnish {
namespace {

/// A corner before the division by w: pixels times w.
struct SeenCorner {
  float x, y, w;
};

/// The triangle of a fragment with its corners.
struct SeenTriangle {
  const RasterPage& page;
  const RasterSurface& surface;
  std::array<uint16_t, 3> corners;
  std::array<SeenCorner, 3> seen;
  bool of_original;
};

/// Parts of the corners in a point, which sum to 1.
struct Weights {
  std::array<float, 3> of;
  float facing;  // below 0: the point is on the triangle's back
};

float times(const PageProjection::Row& row, const Vec3f& at) {
  return row[0] * at[0] + row[1] * at[1] + row[2] * at[2] + row[3];
}

SeenTriangle find_triangle(const ShadedScene& scene, const Fragment& fragment) {
  const RasterPage& page = scene.pages[slot_of_id(fragment.id)];
  const bool of_original = scene.shows_original(fragment.x);
  const RasterSurface& surface = page.surface(of_original);
  SeenTriangle found{page, surface, page.triangles[triangle_of_id(fragment.id)], {}, of_original};
  for (int i = 0; i < 3; ++i) {
    const Vec3f& at = surface.positions[found.corners[i]];
    const PageProjection& projection = scene.projection;
    found.seen[i] = {times(projection.x, at), times(projection.y, at), times(projection.w, at)};
  }
  return found;
}

// Homogeneous coordinates around the point: no corner needs to lie in front of the eye.
Weights weights_at(const SeenTriangle& triangle, float x, float y) {
  std::array<float, 3> right, down;
  for (int i = 0; i < 3; ++i) {
    right[i] = triangle.seen[i].x - x * triangle.seen[i].w;
    down[i] = triangle.seen[i].y - y * triangle.seen[i].w;
  }
  Weights weights;
  float sum = 0;
  for (int i = 0; i < 3; ++i) {
    const int next = (i + 1) % 3, last = (i + 2) % 3;
    weights.of[i] = right[next] * down[last] - right[last] * down[next];
    sum += weights.of[i];
  }
  weights.facing = -sum;  // y runs down
  const float per_sum = sum != 0 ? 1 / sum : 0;
  for (float& each : weights.of) each *= per_sum;
  return weights;
}

// Places of samples are rounded: a point may lie a little outside its triangle.
Weights within(Weights weights) {
  float sum = 0;
  for (float& each : weights.of) {
    each = greater(each, 0);
    sum += each;
  }
  const float per_sum = 1 / greater(sum, 1e-30f);
  for (float& each : weights.of) each *= per_sum;
  return weights;
}

template <typename Value>
float between(const Weights& weights, const Value& of_corner) {
  return weights.of[0] * of_corner(0) + weights.of[1] * of_corner(1) + weights.of[2] * of_corner(2);
}

ShadeVector original_place(const SeenTriangle& triangle, const Weights& weights) {
  const auto part = [&](int axis) {
    return between(weights, [&](int i) {
      return triangle.page.original.positions[triangle.corners[i]][axis];
    });
  };
  return {part(0), part(1), part(2)};
}

ShadeVector flat_normal(const SeenTriangle& triangle) {
  const auto at = [&](int i) {
    const Vec3f& position = triangle.surface.positions[triangle.corners[i]];
    return ShadeVector{position.x(), position.y(), position.z()};
  };
  return cross(at(1) - at(0), at(2) - at(0));
}

ShadeVector smooth_normal(const SeenTriangle& triangle, const Weights& weights, float& ridge) {
  ShadeVector sum{0, 0, 0};
  ridge = 0;
  for (int i = 0; i < 3; ++i) {
    const RasterNormal& normal = triangle.surface.normals[triangle.corners[i]];
    sum = sum + weights.of[i] * ShadeVector{float(normal.x), float(normal.y), float(normal.z)};
    ridge += weights.of[i] * static_cast<float>(normal.ridge);
  }
  ridge /= 32767;
  return sum;
}

ShadeVector in_camera(const PageProjection& projection, ShadeVector n) {
  const Eigen::Matrix3f& axes = projection.axes;
  return {axes(0, 0) * n.x + axes(0, 1) * n.y + axes(0, 2) * n.z,
          axes(1, 0) * n.x + axes(1, 1) * n.y + axes(1, 2) * n.z,
          axes(2, 0) * n.x + axes(2, 1) * n.y + axes(2, 2) * n.z};
}

ShadeVector blue_to_red(float signed_part) {
  const float part = lesser(greater(signed_part, -1), 1);
  return mixed(shade::kPlain, part < 0 ? shade::kBlue : shade::kRed, std::abs(part));
}

ShadeVector colour_between(const SeenTriangle& triangle, const Weights& weights,
                           std::span<const Rgba8> colours) {
  if (colours.empty()) return {0, 0, 0};
  const auto part = [&](int channel) {
    return between(weights, [&](int i) { return float(colours[triangle.corners[i]][channel]); }) /
           255;
  };
  return linear({part(0), part(1), part(2)});
}

// How the weights, before their division by the sum, change from a pixel to the next one.
struct WeightSteps {
  std::array<float, 3> right, down;
};

WeightSteps weight_steps(const SeenTriangle& triangle, float x, float y) {
  WeightSteps steps;
  for (int i = 0; i < 3; ++i) {
    const SeenCorner& next = triangle.seen[(i + 1) % 3];
    const SeenCorner& last = triangle.seen[(i + 2) % 3];
    steps.right[i] = last.w * (next.y - y * next.w) - next.w * (last.y - y * last.w);
    steps.down[i] = next.w * (last.x - x * last.w) - last.w * (next.x - x * next.w);
  }
  return steps;
}

ShadeVector texture_colour(const SeenTriangle& triangle, uint32_t number, const Weights& weights,
                           float x, float y) {
  const PageTexture& texture = *triangle.page.texture;
  const TextureChart& chart = texture.charts[texture.chart_of_triangle[number]];
  std::array<TexelPoint, 3> of_corner;
  for (int i = 0; i < 3; ++i) {
    const Vec3f& at = triangle.page.original.positions[triangle.corners[i]];
    of_corner[i] = {times(chart.u, at), times(chart.v, at)};
  }
  const TexelPoint place{between(weights, [&](int i) { return of_corner[i].x; }),
                         between(weights, [&](int i) { return of_corner[i].y; })};
  const float per_sum = weights.facing != 0 ? -1 / weights.facing : 0;
  const auto step = [&](const std::array<float, 3>& of_weights) {
    TexelPoint sum;
    for (int i = 0; i < 3; ++i) {
      sum.x += of_weights[i] * (of_corner[i].x - place.x);
      sum.y += of_weights[i] * (of_corner[i].y - place.y);
    }
    return TexelPoint{per_sum * sum.x, per_sum * sum.y};
  };
  const WeightSteps steps = weight_steps(triangle, x, y);
  return linear(texel_colour(texture, place, step(steps.right), step(steps.down)));
}

ShadeVector changed_texel(const SeenTriangle& triangle, const Weights& weights, ShadeVector texel) {
  const auto at = [&](int i) { return triangle.page.moved_texels[triangle.corners[i]]; };
  const float gain = between(weights, [&](int i) { return at(i).gain; });
  const auto changed = [&](float light, int channel) {
    return greater(gain * light + between(weights, [&](int i) { return at(i).light[channel]; }), 0);
  };
  return {changed(texel.x, 0), changed(texel.y, 1), changed(texel.z, 2)};
}

ShadeVector scan_colour(const SeenTriangle& triangle, uint32_t number, const Weights& weights,
                        float x, float y) {
  const RasterPage& page = triangle.page;
  if (page.texture == nullptr)
    return colour_between(triangle, weights, page.colours(triangle.of_original));
  const ShadeVector texel = texture_colour(triangle, number, weights, x, y);
  const bool is_changed = !triangle.of_original && !page.moved_texels.empty() &&
                          std::ranges::any_of(triangle.corners, [&](uint16_t corner) {
                            return !page.moved_texels[corner].is_none();
                          });
  return is_changed ? changed_texel(triangle, weights, texel) : texel;
}

// As `overlay` of the vertex shader: sRGB times the fourth.
void cover_with_marks(const ShadedScene& scene, const SeenTriangle& triangle,
                      const Weights& weights, const Fragment& fragment, ShadeVector& base) {
  const auto mark = [&](int i) { return triangle.page.marks[triangle.corners[i]]; };
  const auto overlay = [&](int shift) {
    return between(weights, [&](int i) {
      const int packed = mark(i).overlay;
      return (packed & 1) != 0 ? static_cast<float>(packed >> shift & 15) / 15 : 0.0f;
    });
  };
  const float cover = between(weights, [&](int i) { return float(mark(i).overlay & 1); });
  if (cover > 0) {
    const ShadeVector colour{overlay(12), overlay(8), overlay(4)};
    base = mixed(base, linear((1 / cover) * colour), shade::kOverlayStrength * cover);
  }
  const float hatched = between(weights, [&](int i) { return float(mark(i).overlay >> 1 & 1); });
  const int up = scene.projection.size.height - 1 - fragment.y;
  const float stripe = static_cast<float>(fragment.x + up + 1) / shade::kHatchPixels;
  const bool is_stripe = stripe - std::floor(stripe) < shade::kStripePart;
  base = mixed(base, shade::kHeld,
               hatched * (is_stripe ? shade::kStripeStrength : shade::kBetweenStripesStrength));
  const float tint = between(weights, [&](int i) { return float(mark(i).tint); }) / 255;
  base = mixed(base, scene.tint, shade::kTintStrength * tint * (1 - hatched));
}

ShadeVector base_colour(const ShadedScene& scene, const SeenTriangle& triangle,
                        const Weights& weights, const Fragment& fragment, float x, float y) {
  ShadeVector base = scene.base;
  const bool is_marked = !triangle.page.marks.empty();
  if (scene.colouring == Colouring::kCells) {
    base = blue_to_red(!is_marked ? 0 : between(weights, [&](int i) {
      return static_cast<float>(triangle.page.marks[triangle.corners[i]].value) / 127;
    }));
  }
  if (scene.colouring == Colouring::kDisplacement) {
    const bool is_still = triangle.of_original || triangle.page.along_normal.empty();
    const float moved = is_still ? 0 : between(weights, [&](int i) {
      return triangle.page.along_normal[triangle.corners[i]];
    });
    base = blue_to_red(moved / (moved < 0 ? scene.displacement_low : scene.displacement_high));
  }
  if (scene.colouring == Colouring::kScan)
    base = scan_colour(triangle, triangle_of_id(fragment.id), weights, x, y);
  if (is_marked) cover_with_marks(scene, triangle, weights, fragment, base);
  return base;
}

/// Keeps the colour that rings put over a surface, and the part of it that they leave.
struct RingCover {
  ShadeVector colour{0, 0, 0};
  float left = 1;
};

// At the middle of the pixel; steps to the pixels beside it give a pixel's length.
RingCover ring_cover(const ShadedScene& scene, const SeenTriangle& triangle,
                     const Fragment& fragment) {
  RingCover cover;
  if (scene.rings.empty()) return cover;
  const float x = static_cast<float>(fragment.x) + 0.5f, y = static_cast<float>(fragment.y) + 0.5f;
  const ShadeVector here = original_place(triangle, weights_at(triangle, x, y));
  const ShadeVector beside = original_place(triangle, weights_at(triangle, x + 1, y));
  const ShadeVector below = original_place(triangle, weights_at(triangle, x, y + 1));
  for (const ShadedRing& ring : scene.rings) {
    const float away = length_of(here - ring.centre) - ring.radius;
    const float dx = length_of(beside - ring.centre) - ring.radius - away;
    const float dy = length_of(below - ring.centre) - ring.radius - away;
    const float pixels = std::abs(away) / greater(std::sqrt(dx * dx + dy * dy), 1e-12f);
    const float part = 1 - smooth_step(shade::kRingInnerPixels, shade::kRingOuterPixels, pixels);
    cover.colour = mixed(cover.colour, ring.colour, part);
    cover.left *= 1 - part;
  }
  return cover;
}

// An edge is a pixel wide, half of it on each side's triangle.
int edges_at(const SeenTriangle& triangle, float x, float y) {
  int count = 0;
  for (int i = 0; i < 3; ++i) {
    const SeenCorner& from = triangle.seen[i];
    const SeenCorner& to = triangle.seen[(i + 1) % 3];
    if (from.w <= 0 || to.w <= 0) continue;
    const float from_x = from.x / from.w, from_y = from.y / from.w;
    const float dx = to.x / to.w - from_x, dy = to.y / to.w - from_y;
    const float across = dx * (y - from_y) - dy * (x - from_x);
    count += across * across <= 0.25f * (dx * dx + dy * dy);
  }
  return count;
}

}  // namespace

static void put_eye(const PageProjection& projection, float x, float y, ShadeBatch& batch, int i) {
  if (projection.is_parallel) {
    batch.eye_x[i] = batch.eye_y[i] = 0;
  } else {
    const auto width = static_cast<float>(projection.size.width);
    const auto height = static_cast<float>(projection.size.height);
    batch.eye_x[i] = (1 - 2 * x / width) * projection.half_view.x();
    batch.eye_y[i] = (2 * y / height - 1) * projection.half_view.y();
  }
  batch.eye_z[i] = 1;
}

static void put_normal(const ShadedScene& scene, const SeenTriangle& triangle,
                       const Weights& weights, ShadeBatch& batch, int i) {
  ShadeVector n = smooth_normal(triangle, weights, batch.ridge[i]);
  if (scene.flat) n = flat_normal(triangle);
  n = in_camera(scene.projection, n);
  const float towards = n.x * batch.eye_x[i] + n.y * batch.eye_y[i] + n.z * batch.eye_z[i];
  if (scene.flat && towards < 0) n = -1.0f * n;
  batch.normal_x[i] = n.x;
  batch.normal_y[i] = n.y;
  batch.normal_z[i] = n.z;
  batch.facing[i] = weights.facing;
}

void prefetch_triangle(const ShadedScene& scene, const Fragment& fragment) {
  const RasterPage& page = scene.pages[slot_of_id(fragment.id)];
  __builtin_prefetch(&page.triangles[triangle_of_id(fragment.id)]);
}

void prefetch_corners(const ShadedScene& scene, const Fragment& fragment) {
  const RasterPage& page = scene.pages[slot_of_id(fragment.id)];
  const RasterSurface& surface = page.surface(scene.shows_original(fragment.x));
  for (const uint16_t corner : page.triangles[triangle_of_id(fragment.id)]) {
    __builtin_prefetch(&surface.positions[corner]);
    __builtin_prefetch(&surface.normals[corner]);
  }
}

// OpenGL's drivers light a fragment here: a pixel's middle may lie outside its triangle.
static std::array<float, 2> lit_place(const SamplePlaces& places, const Fragment& fragment) {
  const bool is_whole = fragment.samples == (1 << places.count) - 1;
  const int first = std::countr_zero(static_cast<unsigned>(fragment.samples));
  const int x = is_whole ? kSubpixels / 2 : places.x[first];
  const int y = is_whole ? kSubpixels / 2 : places.y[first];
  return {static_cast<float>(fragment.x) + static_cast<float>(x) / kSubpixels,
          static_cast<float>(fragment.y) + static_cast<float>(y) / kSubpixels};
}

void add_fragment(const ShadedScene& scene, const SamplePlaces& places, const Fragment& fragment,
                  ShadeBatch& batch, EdgeCounts& edges) {
  const int i = batch.count++;
  const SeenTriangle triangle = find_triangle(scene, fragment);
  const auto [x, y] = lit_place(places, fragment);
  const Weights weights = within(weights_at(triangle, x, y));
  put_eye(scene.projection, x, y, batch, i);
  put_normal(scene, triangle, weights, batch, i);
  const ShadeVector base = base_colour(scene, triangle, weights, fragment, x, y);
  batch.base_r[i] = base.x;
  batch.base_g[i] = base.y;
  batch.base_b[i] = base.z;
  const RingCover cover = ring_cover(scene, triangle, fragment);
  batch.over_r[i] = cover.colour.x;
  batch.over_g[i] = cover.colour.y;
  batch.over_b[i] = cover.colour.z;
  batch.left[i] = cover.left;
  if (!scene.wireframe) return;
  for (int s = 0; s < places.count; ++s)
    edges[s] = static_cast<uint8_t>(
        edges_at(triangle, static_cast<float>(fragment.x) + float(places.x[s]) / kSubpixels,
                 static_cast<float>(fragment.y) + float(places.y[s]) / kSubpixels));
}

}  // namespace burnish
