#include "common/grid/corner_bricks.h"

#include <algorithm>

#include "common/base/parallel.h"

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

/// Returns the key of a cell's brick, or of a brick above it.
GridKey brick_key(const GridKey& cell, int above) {
  return {morton_key(morton_point(cell.place >> kBrickShift) + corner_offset(above)),
          cell.component};
}

}  // namespace

CornerBricks::CornerBricks(std::span<const GridKey> cells) {
  find_runs(cells);
  for (Run& run : runs_) add_corners(run, cells);
  merge();
  order_corners();
}

void CornerBricks::find_runs(std::span<const GridKey> cells) {
  const auto n = static_cast<int32_t>(cells.size());
  for (int32_t first = 0, last = 0; first < n; first = last) {
    const GridKey& key = cells[first];
    while (last < n && cells[last].place >> kBrickShift == key.place >> kBrickShift &&
           cells[last].component == key.component)
      ++last;
    runs_.push_back({first, last, 0});
  }
}

void CornerBricks::add_corners(Run& run, std::span<const GridKey> cells) {
  std::array<uint64_t, kCornersPerCell> corners = {};
  for (int32_t c = run.first; c < run.last; ++c)
    for (const Place& place : places_of(cells[c])) corners[place.brick] |= uint64_t{1} << place.bit;
  for (int above = 0; above < kCornersPerCell; ++above) {
    if (corners[above] == 0) continue;
    run.bricks |= static_cast<uint8_t>(1 << above);
    bricks_.push_back({brick_key(cells[run.first], above), corners[above], 0});
  }
}

// Merges bricks of the same key into one.
void CornerBricks::merge() {
  parallel_sort(bricks_.begin(), bricks_.end(),
                [](const Brick& a, const Brick& b) { return a.key < b.key; });
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

// Calls visit(brick, bit) for all corners in rising order. If bricks of several components share a
// place, neighbours in this order belong to different bricks.
template <typename Visit>
void CornerBricks::for_each_corner(Visit&& visit) const {
  for (auto first = bricks_.begin(), last = first; first != bricks_.end(); first = last) {
    uint64_t of_all = 0;
    for (; last != bricks_.end() && last->key.place == first->key.place; ++last)
      of_all |= last->corners;
    for (uint64_t left = of_all; left != 0; left &= left - 1) {
      const int bit = __builtin_ctzll(left);
      for (auto brick = first; brick != last; ++brick)
        if (brick->corners >> bit & 1) visit(*brick, bit);
    }
  }
}

void CornerBricks::order_corners() {
  int32_t next = 0;
  for_each_corner([&](const Brick& brick, int bit) {
    const uint64_t before = brick.corners & ((uint64_t{1} << bit) - 1);
    index_[brick.first + __builtin_popcountll(before)] = next++;
  });
}

std::vector<GridKey> CornerBricks::corners() const {
  std::vector<GridKey> corners;
  corners.reserve(index_.size());
  for_each_corner([&](const Brick& brick, int bit) {
    corners.push_back(
        {brick.key.place << kBrickShift | static_cast<MortonKey>(bit), brick.key.component});
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
