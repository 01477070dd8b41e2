#include "common/mesh/rewrite/pictures/texel_changes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

#include "common/mesh/srgb.h"

namespace burnish {

namespace {

constexpr uint32_t kBandRowsMax = 160;  // of a rewriter, with room for a JPEG's largest MCUs
constexpr uint32_t kGroupRows = 8;      // what a thread draws at once
constexpr float kLeastTint = 1 / 64.F;  // of a channel: below it no texel shows the change

/// A value that is linear over the picture, by texels.
struct Plane {
  double at_first = 0, per_x = 0, per_y = 0;

  /// Returns the value at a texel's centre, and the step to the next one.
  std::array<float, 2> at(uint32_t x, uint32_t y) const {
    return {static_cast<float>(at_first + x * per_x + y * per_y), static_cast<float>(per_x)};
  }
};

/// A side of a triangle, from its upper end. Both triangles of a side have the same numbers.
struct Side {
  Eigen::Vector2d begin, end;
  double slope;

  Side(const Eigen::Vector2d& a, const Eigen::Vector2d& b) : begin(a), end(b) {
    if (b.y() < a.y() || (b.y() == a.y() && b.x() < a.x())) std::swap(begin, end);
    slope = (end.x() - begin.x()) / (end.y() - begin.y());
  }
  bool crosses(double y) const { return begin.y() <= y && y < end.y(); }
  double x_at(double y) const { return begin.x() + (y - begin.y()) * slope; }
};

/// A triangle on the picture.
class DrawnTriangle {
 public:
  explicit DrawnTriangle(const std::array<Eigen::Vector2d, 3>& corners)
      : sides_{{{corners[0], corners[1]}, {corners[1], corners[2]}, {corners[2], corners[0]}}} {
    const Eigen::Vector2d p = corners[1] - corners[0], q = corners[2] - corners[0];
    area_ = p.x() * q.y() - p.y() * q.x();
    const double x = 0.5 - corners[0].x(), y = 0.5 - corners[0].y();
    weights_[1] = {(x * q.y() - y * q.x()) / area_, q.y() / area_, -q.x() / area_};
    weights_[2] = {(p.x() * y - p.y() * x) / area_, -p.y() / area_, p.x() / area_};
  }

  bool has_area() const { return area_ != 0; }

  /// Returns the value between the corners' values.
  Plane between(const std::array<double, 3>& values) const {
    const double one = values[1] - values[0], other = values[2] - values[0];
    return {values[0] + one * weights_[1].at_first + other * weights_[2].at_first,
            one * weights_[1].per_x + other * weights_[2].per_x,
            one * weights_[1].per_y + other * weights_[2].per_y};
  }

  /// Returns the texels of a row whose centres lie inside: first, and behind the last. A centre on
  /// a side is in one of the two triangles that share it.
  std::array<uint32_t, 2> columns(uint32_t row, uint32_t width) const {
    double left = HUGE_VAL, right = -HUGE_VAL;
    for (const Side& side : sides_) {
      if (!side.crosses(row + 0.5)) continue;
      const double x = side.x_at(row + 0.5);
      left = std::min(left, x);
      right = std::max(right, x);
    }
    if (!(left < right)) return {0, 0};
    const auto first_from = [&](double x) {
      return static_cast<uint32_t>(std::clamp(std::ceil(x - 0.5), 0.0, double{1} * width));
    };
    return {first_from(left), first_from(right)};
  }

 private:
  std::array<Side, 3> sides_;
  std::array<Plane, 3> weights_;  // of the second and the third corner
  double area_;
};

/// A triangle's part of one channel: the change of its light, and what multiplies the texture.
struct ChannelPlanes {
  Plane light, tint;
};

/// The change at a corner, by channel.
struct ChangedCorner {
  Vec3f gain = Vec3f::Ones();
  Vec3f light = Vec3f::Zero();
};
using ChangedCorners = std::array<ChangedCorner, 3>;

ChangedCorners corners_of(const TexelEdit& edit, uint32_t triangle) {
  const Triangle& vertices = edit.surface.mesh.triangles[triangle];
  ChangedCorners corners;
  for (size_t k = 0; k < 3; ++k) {
    const TexelChange texel = edit.colours.texel(vertices[k]);
    const Vec3f level = edit.seams != nullptr ? edit.seams->factor(triangle, k) : Vec3f::Ones();
    corners[k] = {texel.gain * level, texel.light};
  }
  return corners;
}

bool has_gains(const ChangedCorners& corners) {
  return std::ranges::any_of(corners, [](const auto& one) { return one.gain != Vec3f::Ones(); });
}

ChannelPlanes planes_of(const TexturedSurface& surface, const ChangedCorners& corners,
                        const DrawnTriangle& drawn, uint32_t triangle, size_t channel) {
  const SurfaceTextures& textures = surface.textures;
  const float factor =
      textures.materials[textures.triangles[triangle].material].factor[static_cast<int>(channel)];
  std::array<double, 3> light, tint;
  tint.fill(factor);
  for (size_t k = 0; k < 3; ++k) {
    const uint32_t v = surface.mesh.triangles[triangle][k];
    light[k] = corners[k].light[static_cast<int>(channel)];
    if (surface.mesh.has_colours())
      tint[k] *= double{linear_of_srgb(surface.mesh.colours[v][channel])};
  }
  return {drawn.between(light), drawn.between(tint)};
}

Plane gain_plane(const ChangedCorners& corners, const DrawnTriangle& drawn, size_t channel) {
  const auto i = static_cast<int>(channel);
  return drawn.between(
      {corners[0].gain[i] - 1.0, corners[1].gain[i] - 1.0, corners[2].gain[i] - 1.0});
}

}  // namespace

uint64_t TexelChanges::bytes_of(size_t triangles, uint32_t width) {
  constexpr uint64_t kRowsOfTriangle = 4;  // on average in a band
  return triangles * (2 * sizeof(Visit) + kRowsOfTriangle * sizeof(uint32_t)) +
         uint64_t{width} * (kBandRowsMax + 2 * kGutterTexels) * sizeof(Change);
}

TexelChanges::TexelChanges(const TexelEdit& edit, std::span<const uint32_t> triangles,
                           const PicturePlace& place, uint32_t width, uint32_t height)
    : edit_(edit), place_(place), width_(width), height_(height) {
  visits_.reserve(triangles.size());
  for (const uint32_t t : triangles) {
    const auto corners = place.corners(t);
    const auto [low, high] = std::minmax({corners[0].y(), corners[1].y(), corners[2].y()});
    const double first = std::max(std::ceil(low - 0.5), 0.0);
    const double last = std::min(std::floor(high - 0.5), height - 1.0);
    if (first <= last)
      visits_.push_back({static_cast<uint32_t>(first), static_cast<uint32_t>(last), t});
  }
  std::ranges::stable_sort(visits_, {}, &Visit::first);
}

void TexelChanges::activate(uint32_t first, uint32_t end) {
  std::erase_if(active_, [&](const Visit& visit) { return visit.last < first; });
  for (; next_ < visits_.size() && visits_[next_].first < end; ++next_)
    active_.push_back(visits_[next_]);
}

void TexelChanges::sort_into_groups(uint32_t first, uint32_t end) {
  group_begins_.assign((end - first + kGroupRows - 1) / kGroupRows + 1, 0);
  const auto for_each_group = [&](const Visit& visit, const auto& use) {
    const uint32_t last = (std::min(visit.last, end - 1) - first) / kGroupRows;
    for (uint32_t g = (std::max(visit.first, first) - first) / kGroupRows; g <= last; ++g) use(g);
  };
  for (const Visit& visit : active_)
    for_each_group(visit, [&](uint32_t group) { ++group_begins_[group + 1]; });
  std::partial_sum(group_begins_.begin(), group_begins_.end(), group_begins_.begin());
  in_groups_.resize(group_begins_.back());
  std::vector<uint32_t> next(group_begins_.begin(), group_begins_.end() - 1);
  for (const Visit& visit : active_)
    for_each_group(visit, [&](uint32_t group) { in_groups_[next[group]++] = visit.triangle; });
}

/// Returns whether a texel changes.
bool TexelChanges::draw_rows(uint32_t first, uint32_t end) {
  changes_.assign(size_t{end - first} * width_, Change());
  const size_t groups = group_begins_.size() - 1;
  bool is_changed = false;
#pragma omp parallel for schedule(dynamic) reduction(|| : is_changed)
  for (size_t group = 0; group < groups; ++group) {
    const auto from = first + static_cast<uint32_t>(group) * kGroupRows;
    const uint32_t to = std::min(from + kGroupRows, end);
    for (uint32_t i = group_begins_[group]; i < group_begins_[group + 1]; ++i)
      draw(in_groups_[i], from, to, first);
    for (uint32_t y = from; y < to; ++y) is_changed = take_means(row_of(y - first)) || is_changed;
  }
  return is_changed;
}

/// Returns whether a texel changes.
bool TexelChanges::take_means(std::span<Change> row) {
  bool is_changed = false;
  for (Change& change : row)
    for (float& part : change.parts) {
      if (change.triangles > 1) part /= change.triangles;
      is_changed = is_changed || part != 0;
    }
  return is_changed;
}

void TexelChanges::draw(uint32_t triangle, uint32_t from, uint32_t to, uint32_t first) {
  const DrawnTriangle drawn(place_.corners(triangle));
  if (!drawn.has_area()) return;
  const bool is_edited = edit_.changes(triangle);
  const ChangedCorners corners = is_edited ? corners_of(edit_, triangle) : ChangedCorners();
  const bool is_gained = has_gains(corners);
  std::array<ChannelPlanes, 3> planes;
  std::array<Plane, 3> gains;
  for (size_t i = 0; is_edited && i < 3; ++i)
    planes[i] = planes_of(edit_.surface, corners, drawn, triangle, i);
  for (size_t i = 0; is_gained && i < 3; ++i) gains[i] = gain_plane(corners, drawn, i);
  for (uint32_t y = from; y < to; ++y) {
    const auto [begin, end] = drawn.columns(y, width_);
    if (begin >= end) continue;
    const std::span<Change> texels = row_of(y - first).subspan(begin, end - begin);
    for (Change& texel : texels) {
      texel.level = 1;
      if (texel.triangles < std::numeric_limits<uint16_t>::max()) ++texel.triangles;
    }
    for (size_t i = 0; is_edited && i < 3; ++i)
      add_row(texels, i, planes[i].light.at(begin, y), planes[i].tint.at(begin, y));
    for (size_t i = 0; is_gained && i < 3; ++i) add_gains(texels, i, gains[i].at(begin, y));
  }
}

/// Adds the change of a channel to texels side by side. Values and their steps: of the light, and
/// of the factor of the texture.
void TexelChanges::add_row(std::span<Change> texels, size_t channel, std::array<float, 2> light,
                           std::array<float, 2> tint) {
  for (size_t x = 0; x < texels.size(); ++x) {
    const auto step = static_cast<float>(x);
    const float shown = tint[0] + step * tint[1];
    if (shown >= kLeastTint) texels[x].parts[channel] += (light[0] + step * light[1]) / shown;
  }
}

void TexelChanges::add_gains(std::span<Change> texels, size_t channel, std::array<float, 2> gain) {
  for (size_t x = 0; x < texels.size(); ++x)
    texels[x].parts[3 + channel] += gain[0] + static_cast<float>(x) * gain[1];
}

/// Gives texels without a change the mean of those around that have lower levels.
void TexelChanges::extend(uint32_t rows, uint16_t level) {
  std::vector<std::vector<Found>> found(rows);
#pragma omp parallel for schedule(dynamic)
  for (uint32_t row = 0; row < rows; ++row) find_around(row, rows, level, found[row]);
  for (uint32_t row = 0; row < rows; ++row)
    for (const Found& one : found[row]) row_of(row)[one.x] = one.change;
}

void TexelChanges::find_around(uint32_t row, uint32_t rows, uint16_t level,
                               std::vector<Found>& found) const {
  const uint32_t top = row == 0 ? 0 : row - 1, bottom = std::min(row + 1, rows - 1);
  for (uint32_t x = 0; x < width_; ++x) {
    if (changes_[size_t{row} * width_ + x].level != 0) continue;
    Found one{x, {}};
    float count = 0;
    for (uint32_t y = top; y <= bottom; ++y)
      for (uint32_t i = x == 0 ? 0 : x - 1; i <= std::min(x + 1, width_ - 1); ++i) {
        const Change& near = changes_[size_t{y} * width_ + i];
        if (near.level == 0) continue;
        ++count;
        for (size_t c = 0; c < near.parts.size(); ++c) one.change.parts[c] += near.parts[c];
      }
    if (count == 0) continue;
    for (float& part : one.change.parts) part /= count;
    one.change.level = level;
    found.push_back(one);
  }
}

/// Returns how many texels that changed several triangles show.
uint64_t TexelChanges::apply(std::span<const Change> changes, std::span<FileTexel> texels,
                             uint16_t max) const {
  uint64_t shared = 0;
#pragma omp parallel for schedule(static) reduction(+ : shared)
  for (size_t t = 0; t < texels.size(); ++t) {
    const FileTexel before = texels[t];
    const auto& parts = changes[t].parts;
    for (size_t i = 0; i < 3; ++i) {
      const float gain = parts[3 + i];
      if (parts[i] == 0 && gain == 0) continue;
      const float light = light_.of_value(before[i], max);
      texels[t][i] = light_.value_of(light + gain * light + parts[i], max);
    }
    shared += changes[t].triangles > 1 && texels[t] != before ? 1 : 0;
  }
  return shared;
}

Status TexelChanges::change(const FileRows& rows, const std::function<bool()>& goes_on) {
  const uint32_t first = rows.first - std::min(rows.first, kGutterTexels);
  const uint32_t end = std::min(rows.first + rows.count + kGutterTexels, height_);
  activate(first, end);
  sort_into_groups(first, end);
  if (goes_on && !goes_on()) return cancelled("changing texels was cancelled");
  if (!draw_rows(first, end)) return Status::ok();
  for (uint16_t level = 2; level < 2 + kGutterTexels; ++level) extend(end - first, level);
  const auto changes = std::span<const Change>(changes_).subspan(
      size_t{rows.first - first} * width_, rows.texels.size());
  shared_texels_ += apply(changes, rows.texels, rows.max);
  return Status::ok();
}

}  // namespace burnish
