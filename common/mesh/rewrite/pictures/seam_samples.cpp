#include "common/mesh/rewrite/pictures/seam_samples.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "common/mesh/rewrite/pictures/picture_place.h"
#include "common/mesh/rewrite/pictures/shown_light.h"
#include "common/mesh/textures/shown_picture.h"
#include "common/picture/picture_rows.h"

namespace burnish {

namespace {

using Place = Eigen::Vector2d;

// Linear sampling reads texels up to half a texel beyond the triangle, as renderers do.
constexpr double kInsetTexels = 0.5;
constexpr double kInsetMax = 0.25;  // of the way to the third corner

/// A texel's part of a sample.
struct Tap {
  uint32_t y, x;
  uint32_t sample;
  float weight;
};

/// A side of an edge on some picture.
struct SideOfEdge {
  uint32_t edge;
  uint8_t side;
};

/// Returns a place beside an edge of a triangle, `part` of the way along it.
Place place_beside(const std::array<Place, 3>& corners, const SeamEdge::Side& side, double part) {
  const auto [a, b] = side.corners;
  const Place along = corners[b] - corners[a];
  const Place inwards = corners[3 - a - b] - corners[a];
  const Place on_edge = corners[a] + part * along;
  const double length = along.norm();
  const double height =
      length > 0 ? std::abs(along.x() * inwards.y() - along.y() * inwards.x()) / length : 0;
  const double inset = height > 0 ? std::min(kInsetTexels / height, kInsetMax) : 0;
  return on_edge + inset * (corners[3 - a - b] - on_edge);
}

/// Samples one picture while it is decoded.
class PictureTaps {
 public:
  explicit PictureTaps(std::vector<Vec3f>& lights) : lights_(lights) {}

  void add(const Place& place, uint32_t sample, const PictureSize& size) {
    const auto along = [](double at, uint32_t texels) {
      const double inside = std::clamp(at - 0.5, 0.0, texels - 1.0);
      const auto first = static_cast<uint32_t>(inside);
      return std::pair(first, static_cast<float>(inside - first));
    };
    const auto [x, right] = along(place.x(), size.width);
    const auto [y, below] = along(place.y(), size.height);
    lights_[sample] = Vec3f::Zero();
    for (const auto& [dy, down] : {std::pair(0U, 1 - below), std::pair(1U, below)})
      for (const auto& [dx, across] : {std::pair(0U, 1 - right), std::pair(1U, right)})
        if (down * across > 0) taps_.push_back({y + dy, x + dx, sample, down * across});
  }

  void sort() {
    std::ranges::sort(taps_, {},
                      [](const Tap& tap) { return std::tuple(tap.y, tap.sample, tap.x); });
  }

  void take(const PixelRun& run) {
    for (const Tap& tap : std::ranges::equal_range(taps_, run.y, {}, &Tap::y)) {
      if (tap.x < run.first || (tap.x - run.first) % run.step != 0) continue;
      const Rgba8 pixel = run.pixels[(tap.x - run.first) / run.step];
      for (int i = 0; i < 3; ++i)
        lights_[tap.sample][i] += tap.weight * light_.of_value(pixel[i], 255);
    }
  }

 private:
  std::vector<Vec3f>& lights_;
  std::vector<Tap> taps_;
  ShownLight light_;
};

class SeamSampler {
 public:
  SeamSampler(const TexturedSurface& surface, std::span<const SeamEdge> seams,
              uint64_t others_bytes, const FileBudget& budget)
      : surface_(surface), seams_(seams), others_bytes_(others_bytes), budget_(budget) {}

  Result<SeamSamples> sample() {
    if (budget_) RETURN_IF_ERROR(budget_(others_bytes_ + bytes()));
    samples_.lights.assign(seams_.size() * 2 * SeamSamples::kPerEdge, Vec3f::Constant(-1));
    find_triangles();
    for (uint32_t picture = 0; picture < sides_.size(); ++picture) {
      const Status read = sides_[picture].empty() ? Status::ok() : read_picture(picture);
      if (read.is_ok()) continue;
      if (read.code() == StatusCode::kCancelled || read.code() == StatusCode::kResourceExhausted)
        return read;
      forget(picture);
    }
    return std::move(samples_);
  }

 private:
  uint64_t bytes() const {
    constexpr uint64_t kPerSample = sizeof(Vec3f) + 4 * sizeof(Tap);
    return seams_.size() * 2 * (SeamSamples::kPerEdge * kPerSample + 2 * sizeof(SideOfEdge)) +
           surface_.mesh.triangles.size() * 2 * sizeof(uint32_t);
  }

  void find_triangles() {
    sides_.resize(surface_.textures.pictures.size());
    triangles_.resize(sides_.size());
    for (uint32_t edge = 0; edge < seams_.size(); ++edge)
      for (uint8_t side = 0; side < 2; ++side)
        sides_[shown_picture(surface_.textures, seams_[edge].sides[side].triangle)].push_back(
            {edge, side});
    for (uint32_t t = 0; t < surface_.mesh.triangles.size(); ++t)
      if (const uint32_t picture = shown_picture(surface_.textures, t); picture != kNoTexture)
        triangles_[picture].push_back(t);
  }

  Status read_picture(uint32_t number) {
    const SurfacePicture& picture = surface_.textures.pictures[number];
    ASSIGN_OR_RETURN(const auto file, picture.read());
    PictureTaps taps(samples_.lights);
    const auto begin = [&](const PictureSize& size) -> Status {
      if (budget_) RETURN_IF_ERROR(budget_(others_bytes_ + bytes() + size.decoding_bytes));
      ASSIGN_OR_RETURN(
          const PicturePlace place,
          PicturePlace::find(surface_.textures, triangles_[number], size.width, size.height));
      place_taps(number, place, size, taps);
      return Status::ok();
    };
    const auto goes_on = [&] { return hear(budget_).is_ok(); };
    RETURN_IF_ERROR(read_picture_rows(
        file, picture.name, {begin, [&](const PixelRun& run) { taps.take(run); }, goes_on}));
    return Status::ok();
  }

  void place_taps(uint32_t picture, const PicturePlace& place, const PictureSize& size,
                  PictureTaps& taps) {
    for (const SideOfEdge& one : sides_[picture]) {
      const SeamEdge::Side& side = seams_[one.edge].sides[one.side];
      const auto corners = place.corners(side.triangle);
      for (uint32_t i = 0; i < SeamSamples::kPerEdge; ++i)
        taps.add(place_beside(corners, side, SeamSamples::part(i)),
                 static_cast<uint32_t>(SeamSamples::index(one.edge, one.side, i)), size);
    }
    taps.sort();
  }

  void forget(uint32_t picture) {
    for (const SideOfEdge& one : sides_[picture])
      for (uint32_t i = 0; i < SeamSamples::kPerEdge; ++i)
        samples_.lights[SeamSamples::index(one.edge, one.side, i)] = Vec3f::Constant(-1);
  }

  const TexturedSurface& surface_;
  const std::span<const SeamEdge> seams_;
  const uint64_t others_bytes_;
  const FileBudget& budget_;
  SeamSamples samples_;
  std::vector<std::vector<SideOfEdge>> sides_;    // by picture
  std::vector<std::vector<uint32_t>> triangles_;  // by picture
};

}  // namespace

Result<SeamSamples> sample_seams(const TexturedSurface& surface, std::span<const SeamEdge> seams,
                                 uint64_t others_bytes, const FileBudget& budget) {
  return SeamSampler(surface, seams, others_bytes, budget).sample();
}

}  // namespace burnish
