#include "common/mesh/rewrite/texel_changes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

#include "common/mesh/srgb.h"

namespace burnish {

namespace {

constexpr uint32_t kBandRowsMax = 128;  // of a rewriter, with room for a JPEG's largest MCUs
constexpr float kLeastTint = 1 / 64.F;  // of a channel: below it no texel shows the change

/// A value that is linear over the picture.
struct LinearValue {
  double at_origin = 0, per_x = 0;
};

/// The part of a row of texels that a triangle covers, and where its corners weigh there.
struct Span {
  uint32_t begin = 0, end = 0;
  std::array<LinearValue, 3> weights;
};

/// Returns where a side crosses a height. Both triangles of a side get the same number.
double crossing(Eigen::Vector2d a, Eigen::Vector2d b, double y) {
  if (b.y() < a.y() || (b.y() == a.y() && b.x() < a.x())) std::swap(a, b);
  return a.x() + (y - a.y()) * ((b.x() - a.x()) / (b.y() - a.y()));
}

uint32_t first_centre_from(double x, uint32_t width) {
  return static_cast<uint32_t>(std::clamp(std::ceil(x - 0.5), 0.0, static_cast<double>(width)));
}

/// Returns the texels of a row whose centres lie in a triangle. A centre on a side is in one of the
/// two triangles that share it.
std::optional<Span> span_of(const std::array<Eigen::Vector2d, 3>& corners, uint32_t row,
                            uint32_t width) {
  const double y = row + 0.5;
  double left = HUGE_VAL, right = -HUGE_VAL;
  for (size_t k = 0; k < 3; ++k) {
    const Eigen::Vector2d& a = corners[k];
    const Eigen::Vector2d& b = corners[(k + 1) % 3];
    if ((a.y() <= y) == (b.y() <= y)) continue;
    const double x = crossing(a, b, y);
    left = std::min(left, x);
    right = std::max(right, x);
  }
  if (!(left < right)) return std::nullopt;
  Span span{first_centre_from(left, width), first_centre_from(right, width), {}};
  if (span.begin >= span.end) return std::nullopt;
  const Eigen::Vector2d p = corners[1] - corners[0], q = corners[2] - corners[0];
  const double area = p.x() * q.y() - p.y() * q.x();
  if (area == 0) return std::nullopt;
  const double down = y - corners[0].y(), across = 0.5 - corners[0].x();
  span.weights[1] = {(across * q.y() - down * q.x()) / area, q.y() / area};
  span.weights[2] = {(p.x() * down - p.y() * across) / area, -p.y() / area};
  span.weights[0] = {1 - span.weights[1].at_origin - span.weights[2].at_origin,
                     -span.weights[1].per_x - span.weights[2].per_x};
  return span;
}

/// Returns the sum of the corners' values by weight, at texel `begin` and per texel.
std::array<float, 2> mixed(const Span& span, const std::array<double, 3>& values) {
  double at = 0, step = 0;
  for (size_t k = 0; k < 3; ++k) {
    at += values[k] * (span.weights[k].at_origin + span.begin * span.weights[k].per_x);
    step += values[k] * span.weights[k].per_x;
  }
  return {static_cast<float>(at), static_cast<float>(step)};
}

}  // namespace

uint64_t TexelChanges::bytes_of(size_t triangles, uint32_t width) {
  constexpr uint64_t kRowsOfTriangle = 4;  // on average in a band
  return triangles * (2 * sizeof(Visit) + kRowsOfTriangle * sizeof(uint32_t)) +
         uint64_t{width} * (kBandRowsMax + 2 * kGutterTexels) * sizeof(Change);
}

TexelChanges::TexelChanges(const TexturedSurface& surface, const ColourEdit& edit,
                           std::span<const uint32_t> triangles, const PicturePlace& place,
                           uint32_t width, uint32_t height)
    : surface_(surface), edit_(edit), place_(place), width_(width), height_(height) {
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

void TexelChanges::sort_into_rows(uint32_t first, uint32_t end) {
  row_begins_.assign(end - first + 1, 0);
  const auto for_each_row = [&](const Visit& visit, const auto& use) {
    const uint32_t behind = std::min(visit.last + 1, end);
    for (uint32_t y = std::max(visit.first, first); y < behind; ++y) use(y - first);
  };
  for (const Visit& visit : active_)
    for_each_row(visit, [&](uint32_t row) { ++row_begins_[row + 1]; });
  std::partial_sum(row_begins_.begin(), row_begins_.end(), row_begins_.begin());
  in_rows_.resize(row_begins_.back());
  std::vector<uint32_t> next(row_begins_.begin(), row_begins_.end() - 1);
  for (const Visit& visit : active_)
    for_each_row(visit, [&](uint32_t row) { in_rows_[next[row]++] = visit.triangle; });
}

/// Returns whether a texel changes.
bool TexelChanges::draw_rows(uint32_t first, uint32_t end) {
  changes_.assign(size_t{end - first} * width_, Change());
  bool is_changed = false;
#pragma omp parallel for schedule(dynamic) reduction(|| : is_changed)
  for (uint32_t y = first; y < end; ++y) {
    const std::span<Change> row = row_of(y - first);
    for (uint32_t i = row_begins_[y - first]; i < row_begins_[y - first + 1]; ++i)
      draw(in_rows_[i], y, row);
    for (Change& change : row) {
      for (float& light : change.light) {
        if (change.triangles > 1) light /= change.triangles;
        is_changed = is_changed || light != 0;
      }
    }
  }
  return is_changed;
}

void TexelChanges::draw(uint32_t triangle, uint32_t y, std::span<Change> row) const {
  const auto span = span_of(place_.corners(triangle), y, width_);
  if (!span) return;
  for (uint32_t x = span->begin; x < span->end; ++x) {
    row[x].level = 1;
    if (row[x].triangles < std::numeric_limits<uint16_t>::max()) ++row[x].triangles;
  }
  const Triangle& vertices = surface_.mesh.triangles[triangle];
  if (!edit_.changes(vertices)) return;
  const Vec3f& factor =
      surface_.textures.materials[surface_.textures.triangles[triangle].material].factor;
  const auto mixed_of = [&](const auto& value_of_vertex) {
    return mixed(*span, {static_cast<double>(value_of_vertex(vertices[0])),
                         static_cast<double>(value_of_vertex(vertices[1])),
                         static_cast<double>(value_of_vertex(vertices[2]))});
  };
  for (size_t i = 0; i < 3; ++i) {
    const auto before = mixed_of([&](uint32_t v) { return edit_.before[v][i]; });
    const auto after = mixed_of([&](uint32_t v) { return edit_.after[v][i]; });
    std::array<float, 2> tint = {factor[static_cast<int>(i)], 0};
    if (surface_.mesh.has_colours())
      tint = mixed_of([&](uint32_t v) {
        return factor[static_cast<int>(i)] * linear_of_srgb(surface_.mesh.colours[v][i]);
      });
    for (uint32_t x = span->begin; x < span->end; ++x) {
      const auto step = static_cast<float>(x - span->begin);
      const float change = light_.of_level(after[0] + step * after[1]) -
                           light_.of_level(before[0] + step * before[1]);
      const float shown = tint[0] + step * tint[1];
      if (shown >= kLeastTint) row[x].light[i] += change / shown;
    }
  }
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
        for (size_t c = 0; c < 3; ++c) one.change.light[c] += near.light[c];
      }
    if (count == 0) continue;
    for (float& light : one.change.light) light /= count;
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
    for (size_t i = 0; i < 3; ++i)
      if (changes[t].light[i] != 0)
        texels[t][i] = light_.value_of(light_.of_value(before[i], max) + changes[t].light[i], max);
    shared += changes[t].triangles > 1 && texels[t] != before ? 1 : 0;
  }
  return shared;
}

Status TexelChanges::change(const FileRows& rows, const std::function<bool()>& goes_on) {
  const uint32_t first = rows.first - std::min(rows.first, kGutterTexels);
  const uint32_t end = std::min(rows.first + rows.count + kGutterTexels, height_);
  activate(first, end);
  sort_into_rows(first, end);
  if (goes_on && !goes_on()) return cancelled("changing texels was cancelled");
  if (!draw_rows(first, end)) return Status::ok();
  for (uint16_t level = 2; level < 2 + kGutterTexels; ++level) extend(end - first, level);
  const auto changes = std::span<const Change>(changes_).subspan(
      size_t{rows.first - first} * width_, rows.texels.size());
  shared_texels_ += apply(changes, rows.texels, rows.max);
  return Status::ok();
}

}  // namespace burnish
