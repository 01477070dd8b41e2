#include "server/solver/tuning/crumbs.h"

#include <algorithm>
#include <optional>
#include <span>
#include <utility>

#include "common/base/sort_once.h"
#include "server/solver/cycle/patches.h"
#include "server/solver/hierarchy/corner_sets.h"

namespace burnish {

namespace {

using Corners = std::vector<int32_t>;

class CrumbFinder {
 public:
  CrumbFinder(const SparseGrid& finest, const SheetCorners& sheets)
      : finest_(finest),
        sheets_(sheets),
        shared_of_extra_(sheets.copy_count - finest.corner_count()),
        was_reached_(sheets.copy_count) {
    for (size_t i = 0; i < sheets.shared.size(); ++i)
      for (int32_t k = sheets.start[i]; k < sheets.start[i + 1]; ++k)
        if (sheets.copy[k] >= finest.corner_count())
          shared_of_extra_[sheets.copy[k] - finest.corner_count()] = sheets.shared[i];
  }

  // Finds each piece once, by its first corner that it shares with another piece.
  std::vector<Corners> find() {
    std::vector<Corners> crumbs;
    for (const int32_t copy : sheets_.copy) {
      if (was_reached_[copy]) continue;
      if (std::optional<Corners> crumb = crumb_from(copy)) crumbs.push_back(std::move(*crumb));
    }
    return crumbs;
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

  // Returns all copies of the piece with this copy, or nothing if they are too many. Forgets the
  // seen copies of a large piece: it is quick to find again that it is large.
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

  std::optional<Corners> crumb_from(int32_t copy) {
    std::optional<Corners> piece = piece_from(copy);
    if (!piece) return std::nullopt;
    for (int32_t& corner : *piece) corner = corner_of(corner);
    sort_once(*piece);
    Corners with_ring = *piece;
    for (const int32_t corner : *piece)
      if (is_shared(corner))
        for_each_cell_around(finest_, std::span(&corner, 1), [&](int32_t cell) {
          const auto& corners = finest_.cell_corners[cell];
          with_ring.insert(with_ring.end(), corners.begin(), corners.end());
        });
    sort_once(with_ring);
    return with_ring.size() <= kPatchCornersMax ? with_ring : piece;
  }

  const SparseGrid& finest_;
  const SheetCorners& sheets_;
  Corners shared_of_extra_;  // the corner of each copy beyond the corners
  std::vector<char> was_reached_;
};

}  // namespace

std::vector<Corners> find_crumbs(const SparseGrid& finest, const SheetCorners& sheets) {
  if (sheets.shared.empty()) return {};
  return CrumbFinder(finest, sheets).find();
}

}  // namespace burnish
