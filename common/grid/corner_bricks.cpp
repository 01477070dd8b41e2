#include "common/grid/corner_bricks.h"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "common/base/parallel.h"
#include "common/base/resize_touched.h"
#include "common/base/select_numbers.h"

namespace burnish {

static constexpr int kBrickShift = 6;  // Morton bits of 4×4×4 places
static constexpr int kCellsPerBrick = 1 << kBrickShift;

namespace {

/// The place of a cell's corner: which brick, its own or one of the seven above it, and which bit.
struct Place {
  uint8_t brick;
  uint8_t bit;
};
using Places = std::array<std::array<Place, kCornersPerCell>, kCellsPerBrick>;

Places make_places() {
  Places places;
  for (int cell = 0; cell < kCellsPerBrick; ++cell)
    for (int a = 0; a < kCornersPerCell; ++a) {
      const Vec3i at = morton_point(static_cast<MortonKey>(cell)) + corner_offset(a);
      const Vec3i above = at / 4;
      places[cell][a] = {static_cast<uint8_t>(above.x() + 2 * above.y() + 4 * above.z()),
                         static_cast<uint8_t>(morton_key(at - 4 * above))};
    }
  return places;
}

const Places kPlaces = make_places();

const std::array<Place, kCornersPerCell>& places_of(const GridKey& cell) {
  return kPlaces[cell.place % kCellsPerBrick];
}

using BrickCorners = std::array<uint64_t, kCornersPerCell>;

/// Returns the key of a cell's brick, or of a brick above it.
GridKey brick_key(const GridKey& cell, int above) {
  return {morton_key(morton_point(cell.place >> kBrickShift) + corner_offset(above)),
          cell.component};
}

}  // namespace

CornerBricks::CornerBricks(std::span<const GridKey> cells) {
  find_runs(cells);
  add_bricks(cells);
  merge();
  find_places();
  for_each_corner([&](int32_t corner, const Brick& brick, int bit) {
    const uint64_t before = brick.corners & ((uint64_t{1} << bit) - 1);
    index_[brick.first + __builtin_popcountll(before)] = corner;
  });
}

void CornerBricks::find_runs(std::span<const GridKey> cells) {
  const auto n = static_cast<int32_t>(cells.size());
  const std::vector<int32_t> first = select_numbers(n, [&](int32_t c) {
    return c == 0 || cells[c].place >> kBrickShift != cells[c - 1].place >> kBrickShift ||
           cells[c].component != cells[c - 1].component;
  });
  runs_.resize(first.size());
  for (size_t i = 0; i < first.size(); ++i)
    runs_[i] = {first[i], i + 1 < first.size() ? first[i + 1] : n, 0};
}

// Returns the corners of a run's cells in its own brick and in the seven above it.
static BrickCorners corners_of(const CornerBricks::Run& run, std::span<const GridKey> cells) {
  BrickCorners corners = {};
  for (int32_t c = run.first; c < run.last; ++c)
    for (const Place& place : places_of(cells[c])) corners[place.brick] |= uint64_t{1} << place.bit;
  return corners;
}

void CornerBricks::add_bricks(std::span<const GridKey> cells) {
  std::vector<int32_t> first(runs_.size() + 1, 0);
#pragma omp parallel for schedule(static)
  for (size_t i = 0; i < runs_.size(); ++i) {
    const BrickCorners corners = corners_of(runs_[i], cells);
    for (int above = 0; above < kCornersPerCell; ++above)
      runs_[i].bricks |= static_cast<uint8_t>((corners[above] != 0 ? 1 : 0) << above);
    first[i + 1] = __builtin_popcount(runs_[i].bricks);
  }
  std::partial_sum(first.begin(), first.end(), first.begin());
  bricks_.resize(first.back());
#pragma omp parallel for schedule(static)
  for (size_t i = 0; i < runs_.size(); ++i) {
    const BrickCorners corners = corners_of(runs_[i], cells);
    Brick* next = &bricks_[first[i]];
    for (int above = 0; above < kCornersPerCell; ++above)
      if (corners[above] != 0)
        *next++ = {brick_key(cells[runs_[i].first], above), corners[above], 0};
  }
}

// Merges bricks of the same key into one.
void CornerBricks::merge() {
  parallel_sort(bricks_.begin(), bricks_.end(), [](const Brick& a, const Brick& b) {
    return std::tie(a.key, a.corners) < std::tie(b.key, b.corners);
  });
  size_t kept = 0;
  int32_t corners = 0;
  for (size_t i = 0; i < bricks_.size();) {
    Brick brick = bricks_[i++];
    for (; i < bricks_.size() && bricks_[i].key == brick.key; ++i)
      brick.corners |= bricks_[i].corners;
    brick.first = corners;
    corners += __builtin_popcountll(brick.corners);
    bricks_[kept++] = brick;
  }
  bricks_.resize(kept);
  index_.resize(corners);
}

void CornerBricks::find_places() {
  const auto n = static_cast<int32_t>(bricks_.size());
  places_ = select_numbers(
      n, [&](int32_t i) { return i == 0 || bricks_[i].key.place != bricks_[i - 1].key.place; });
  places_.push_back(n);
}

// Calls visit(corner, brick, bit) for all corners, from several threads. Within a place they rise
// by bit; if bricks of several components share it, then by brick.
template <typename Visit>
void CornerBricks::for_each_corner(Visit&& visit) const {
#pragma omp parallel for schedule(static)
  for (size_t place = 0; place < places_.size() - 1; ++place) {
    const std::span bricks =
        std::span(bricks_).subspan(places_[place], places_[place + 1] - places_[place]);
    uint64_t of_all = 0;
    for (const Brick& brick : bricks) of_all |= brick.corners;
    int32_t corner = bricks.front().first;
    for (uint64_t left = of_all; left != 0; left &= left - 1) {
      const int bit = __builtin_ctzll(left);
      for (const Brick& brick : bricks)
        if (brick.corners >> bit & 1) visit(corner++, brick, bit);
    }
  }
}

std::vector<GridKey> CornerBricks::corners() const {
  std::vector<GridKey> corners;
  resize_touched(corners, index_.size());
  for_each_corner([&](int32_t corner, const Brick& brick, int bit) {
    corners[corner] = {brick.key.place << kBrickShift | static_cast<MortonKey>(bit),
                       brick.key.component};
  });
  return corners;
}

void CornerBricks::number(const Run& run, const GridKey* cells,
                          std::array<int32_t, kCornersPerCell>* cell_corners) const {
  // Index of every corner of the eight bricks, by bit.
  std::array<std::array<int32_t, kCellsPerBrick>, kCornersPerCell> index;
  for (int above = 0; above < kCornersPerCell; ++above) {
    if ((run.bricks >> above & 1) == 0) continue;
    const GridKey key = brick_key(cells[run.first], above);
    const auto is_before = [&](const Brick& brick) { return brick.key < key; };
    const Brick& brick = *std::partition_point(bricks_.begin(), bricks_.end(), is_before);
    const int32_t* next = &index_[brick.first];
    for (uint64_t left = brick.corners; left != 0; left &= left - 1)
      index[above][__builtin_ctzll(left)] = *next++;
  }
  for (int32_t c = run.first; c < run.last; ++c)
    for (int a = 0; a < kCornersPerCell; ++a) {
      const Place place = places_of(cells[c])[a];
      cell_corners[c][a] = index[place.brick][place.bit];
    }
}

}  // namespace burnish
