#include "server/solver/patches.h"

#include <algorithm>
#include <bit>
#include <optional>
#include <span>

namespace burnish {

namespace {

constexpr int64_t kEntriesPerCorner = 16;

using Corners = std::vector<int32_t>;

void sort_once(Corners& corners) {
  std::ranges::sort(corners);
  corners.erase(std::ranges::unique(corners).begin(), corners.end());
}

int64_t entries_of(size_t corners) {
  return static_cast<int64_t>(corners * (corners + 1) / 2);
}

class PatchFinder {
 public:
  PatchFinder(const SparseGrid& finest, const SheetCorners& sheets)
      : finest_(finest),
        sheets_(sheets),
        shared_of_extra_(sheets.copy_count - finest.corner_count()),
        was_reached_(sheets.copy_count) {
    for (size_t i = 0; i < sheets.shared.size(); ++i)
      for (int32_t k = sheets.start[i]; k < sheets.start[i + 1]; ++k)
        if (sheets.copy[k] >= finest.corner_count())
          shared_of_extra_[sheets.copy[k] - finest.corner_count()] = sheets.shared[i];
  }

  // Each piece once, by the first corner that it shares with another.
  std::vector<Corners> find() {
    std::vector<Corners> patches;
    int64_t entries_left = kEntriesPerCorner * finest_.corner_count();
    for (const int32_t copy : sheets_.copy) {
      if (was_reached_[copy]) continue;
      const std::optional<Corners> patch = patch_from(copy);
      if (!patch || entries_of(patch->size()) > entries_left) continue;
      entries_left -= entries_of(patch->size());
      patches.push_back(*patch);
    }
    return patches;
  }

 private:
  int32_t corner_of(int32_t copy) const {
    const int32_t extra = copy - finest_.corner_count();
    return extra < 0 ? copy : shared_of_extra_[extra];
  }
  bool is_shared(int32_t corner) const {
    return std::ranges::binary_search(sheets_.shared, corner);
  }

  template <typename Visit>
  void for_each_sheet_at(int32_t copy, Visit&& visit) const {
    const auto& cells = finest_.cells_of_corner[corner_of(copy)];
    for (int side = 0; side < kCornersPerCell; ++side) {
      if (cells[side] == kNone) continue;
      for (int32_t s = sheets_.first_of_cell[cells[side]];
           s < sheets_.first_of_cell[cells[side] + 1]; ++s)
        if (sheets_.corners[s][side] == copy) visit(s);
    }
  }

  // All copies of the piece that has this one, or none if they are too many. Of a large piece those
  // that were seen are forgotten: it is short work to find again that it is large.
  std::optional<Corners> piece_from(int32_t copy) {
    Corners piece = {copy};
    was_reached_[copy] = true;
    for (size_t next = 0; next < piece.size() && piece.size() <= kPatchCornersMax; ++next)
      for_each_sheet_at(piece[next], [&](int32_t sheet) {
        for (const int32_t other : sheets_.corners[sheet]) {
          if (!was_reached_[other]) piece.push_back(other);
          was_reached_[other] = true;
        }
      });
    if (piece.size() <= kPatchCornersMax) return piece;
    for (const int32_t seen : piece) was_reached_[seen] = false;
    return std::nullopt;
  }

  std::optional<Corners> patch_from(int32_t copy) {
    std::optional<Corners> piece = piece_from(copy);
    if (!piece) return std::nullopt;
    for (int32_t& corner : *piece) corner = corner_of(corner);
    sort_once(*piece);
    Corners with_ring = *piece;
    for (const int32_t corner : *piece)
      if (is_shared(corner)) add_cells_around(corner, with_ring);
    sort_once(with_ring);
    return with_ring.size() <= kPatchCornersMax ? with_ring : piece;
  }

  void add_cells_around(int32_t corner, Corners& corners) const {
    for (const int32_t cell : finest_.cells_of_corner[corner])
      if (cell != kNone)
        corners.insert(corners.end(), finest_.cell_corners[cell].begin(),
                       finest_.cell_corners[cell].end());
  }

  const SparseGrid& finest_;
  const SheetCorners& sheets_;
  Corners shared_of_extra_;  // the corner of each copy beyond the corners
  std::vector<char> was_reached_;
};

// The least colour that no patch has with which this one has a cell in common; 64 if there is none.
class Colours {
 public:
  explicit Colours(const SparseGrid& finest) : finest_(finest), of_cell_(finest.cells.size()) {}

  int take(std::span<const int32_t> patch) {
    uint64_t taken = 0;
    for_each_cell(patch, [&](int32_t cell) { taken |= of_cell_[cell]; });
    const int colour = std::countr_one(taken);
    if (colour < 64) for_each_cell(patch, [&](int32_t cell) { of_cell_[cell] |= 1ull << colour; });
    return colour;
  }

 private:
  template <typename Visit>
  void for_each_cell(std::span<const int32_t> patch, Visit&& visit) const {
    for (const int32_t corner : patch)
      for (const int32_t cell : finest_.cells_of_corner[corner])
        if (cell != kNone) visit(cell);
  }

  const SparseGrid& finest_;
  std::vector<uint64_t> of_cell_;
};

void append(const Corners& patch, Patches& patches) {
  patches.corner.insert(patches.corner.end(), patch.begin(), patch.end());
  patches.start.push_back(static_cast<int32_t>(patches.corner.size()));
  patches.entry_start.push_back(patches.entry_count() + entries_of(patch.size()));
}

}  // namespace

Patches find_patches(const SparseGrid& finest, const SheetCorners& sheets) {
  Patches patches;
  if (sheets.shared.empty()) return patches;
  const std::vector<Corners> found = PatchFinder(finest, sheets).find();
  Colours colours(finest);
  std::array<std::vector<size_t>, 65> by_colour;
  for (size_t i = 0; i < found.size(); ++i) by_colour[colours.take(found[i])].push_back(i);
  for (int colour = 0; colour < 64 && !by_colour[colour].empty(); ++colour) {
    for (const size_t i : by_colour[colour]) append(found[i], patches);
    patches.colour_start.push_back(patches.count());
  }
  return patches;
}

}  // namespace burnish
