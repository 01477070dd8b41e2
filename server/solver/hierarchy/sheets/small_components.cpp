#include "server/solver/hierarchy/sheets/small_components.h"

#include <algorithm>
#include <iterator>
#include <span>
#include <utility>

#include "common/base/disjoint_sets.h"
#include "common/base/select_numbers.h"
#include "common/base/sort_once.h"
#include "server/solver/hierarchy/corner_sets.h"
#include "server/solver/hierarchy/patches.h"

namespace burnish {

namespace {

using Corners = std::vector<int32_t>;

// Returns the corner of each copy.
Corners corners_of_copies(const SparseGrid& finest, const SheetCorners& sheets) {
  Corners corner(sheets.copy_count);
  for (int32_t i = 0; i < finest.corner_count(); ++i) corner[i] = i;
  for (size_t i = 0; i < sheets.shared.size(); ++i)
    for (int32_t k = sheets.start[i]; k < sheets.start[i + 1]; ++k)
      corner[sheets.copy[k]] = sheets.shared[i];
  return corner;
}

// Returns the copies of each piece, the pieces by their least copy.
std::vector<Corners> small_pieces(const SheetCorners& sheets) {
  DisjointSets joined(sheets.copy_count);
#pragma omp parallel for schedule(static)
  for (size_t s = 0; s < sheets.corners.size(); ++s)
    for (const int32_t copy : sheets.corners[s]) joined.join(sheets.corners[s][0], copy);
  Corners size(sheets.copy_count), number(sheets.copy_count, kNone);
#pragma omp parallel for schedule(static)
  for (int32_t copy = 0; copy < sheets.copy_count; ++copy)
    __atomic_add_fetch(&size[joined.root(copy)], 1, __ATOMIC_RELAXED);
  std::vector<Corners> pieces;
  const Corners of_small = select_numbers(sheets.copy_count, [&](int32_t copy) {
    return size[joined.root(copy)] <= static_cast<int32_t>(kPatchCornersMax);
  });
  for (const int32_t copy : of_small) {
    const int32_t root = joined.root(copy);
    if (root == copy) {
      number[root] = static_cast<int32_t>(pieces.size());
      pieces.emplace_back();
    }
    pieces[number[root]].push_back(copy);
  }
  return pieces;
}

Corners patch_of(const SparseGrid& finest, const SheetCorners& sheets, Corners piece) {
  sort_once(piece);
  Corners with_ring = piece;
  for (const int32_t corner : piece)
    if (std::ranges::binary_search(sheets.shared, corner))
      for_each_cell_around(finest, std::span(&corner, 1), [&](int32_t cell) {
        const auto& corners = finest.cell_corners[cell];
        with_ring.insert(with_ring.end(), corners.begin(), corners.end());
      });
  sort_once(with_ring);
  return with_ring.size() <= kPatchCornersMax ? with_ring : piece;
}

/// Small components that hang on each other. One patch after the other would move a chain of them
/// as slowly as any relaxation.
class HangingComponents {
 public:
  HangingComponents(std::vector<SmallComponent> components, const SheetCorners& sheets)
      : components_(std::move(components)), joined_(components_.size()) {
    Corners component_of_copy(sheets.copy_count, kNone);
    for (size_t i = 0; i < components_.size(); ++i)
      for (const int32_t copy : components_[i].copies)
        component_of_copy[copy] = static_cast<int32_t>(i);
    for (size_t i = 0; i < sheets.shared.size(); ++i)
      for (int32_t k = sheets.start[i] + 1; k < sheets.start[i + 1]; ++k) {
        const int32_t one = component_of_copy[sheets.copy[k - 1]],
                      two = component_of_copy[sheets.copy[k]];
        if (one != kNone && two != kNone) pairs_.emplace_back(one, two);
      }
  }

  /// Joins them while a patch has room for both. Two that stay apart need coarse cells.
  std::vector<SmallComponent> joined() {
    for (const auto& [one, two] : pairs_) join(joined_.root(one), joined_.root(two));
    for (const auto& [one, two] : pairs_) {
      SmallComponent &a = components_[joined_.root(one)], &b = components_[joined_.root(two)];
      if (&a != &b) a.needs_coarse_cells = b.needs_coarse_cells = true;
    }
    std::erase_if(components_,
                  [](const SmallComponent& component) { return component.copies.empty(); });
    return std::move(components_);
  }

 private:
  void join(int32_t one, int32_t two) {
    if (one == two) return;
    SmallComponent &kept = components_[std::min(one, two)], &gone = components_[std::max(one, two)];
    Corners patch;
    std::ranges::set_union(kept.patch, gone.patch, std::back_inserter(patch));
    if (patch.size() > kPatchCornersMax) return;
    kept.copies.insert(kept.copies.end(), gone.copies.begin(), gone.copies.end());
    kept.corners.insert(kept.corners.end(), gone.corners.begin(), gone.corners.end());
    kept.patch = std::move(patch);
    gone = {};
    joined_.join(one, two);
  }

  std::vector<SmallComponent> components_;
  DisjointSets joined_;
  std::vector<std::pair<int32_t, int32_t>> pairs_;
};

}  // namespace

std::vector<SmallComponent> find_small_components(const SparseGrid& finest,
                                                  const SheetCorners& sheets) {
  if (sheets.shared.empty()) return {};
  std::vector<SmallComponent> components;
  size_t copies = 0;
  const Corners corner = corners_of_copies(finest, sheets);
  for (Corners& piece : small_pieces(sheets)) {
    Corners corners;
    for (const int32_t copy : piece) corners.push_back(corner[copy]);
    copies += piece.size();
    Corners patch = patch_of(finest, sheets, corners);
    components.push_back({std::move(piece), std::move(corners), std::move(patch)});
  }
  // Without a large piece no coarse depth would be left.
  const bool are_all = copies == static_cast<size_t>(sheets.copy_count);
  for (SmallComponent& component : components) component.needs_coarse_cells = are_all;
  return HangingComponents(std::move(components), sheets).joined();
}

std::vector<int32_t> find_anchors(std::span<const SmallComponent> components,
                                  const SheetCorners& sheets) {
  Corners component_of_copy(sheets.copy_count, kNone), anchors(components.size(), kNone);
  for (size_t i = 0; i < components.size(); ++i)
    for (const int32_t copy : components[i].copies)
      component_of_copy[copy] = static_cast<int32_t>(i);
  // Returns what a copy follows.
  const auto followed = [&](int32_t copy) {
    return component_of_copy[copy] == kNone ? copy : anchors[component_of_copy[copy]];
  };
  for (bool is_new = true; is_new;) {
    is_new = false;
    for (size_t i = 0; i < sheets.shared.size(); ++i) {
      const int32_t begin = sheets.start[i], end = sheets.start[i + 1];
      int32_t anchor = kNone;
      float most = -1;
      for (int32_t k = begin; k < end; ++k) {
        if (followed(sheets.copy[k]) == kNone || sheets.weight[k] <= most) continue;
        anchor = followed(sheets.copy[k]);
        most = sheets.weight[k];
      }
      if (anchor == kNone) continue;
      for (int32_t k = begin; k < end; ++k) {
        if (followed(sheets.copy[k]) != kNone) continue;
        anchors[component_of_copy[sheets.copy[k]]] = anchor;
        is_new = true;
      }
    }
  }
  return anchors;
}

}  // namespace burnish
