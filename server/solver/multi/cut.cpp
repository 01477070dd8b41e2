#include "server/solver/multi/cut.h"

#include <algorithm>

#include "common/base/check.h"
#include "common/base/disjoint_sets.h"
#include "server/solver/hierarchy/corner_sets.h"

namespace burnish {

namespace {

constexpr uint8_t kNobody = 0xff;
static_assert(kShardsMax < kNobody);

// Returns how many finest cells each cell of the border depth has below it.
std::vector<int64_t> weights_of_border(const Hierarchy& hierarchy, int border) {
  std::vector<int64_t> weight(hierarchy.at(hierarchy.finest).grid.cells.size(), 1);
  for (int depth = hierarchy.finest; depth > border; --depth) {
    std::vector<int64_t> of_parents(hierarchy.at(depth - 1).grid.cells.size());
    const std::vector<int32_t>& parent = hierarchy.at(depth).parent_cell;
#pragma omp parallel for schedule(static)
    for (size_t c = 0; c < parent.size(); ++c)
      if (parent[c] != kNone)
        __atomic_add_fetch(&of_parents[parent[c]], weight[c], __ATOMIC_RELAXED);
    weight = std::move(of_parents);
  }
  return weight;
}

std::vector<uint8_t> cut_border(const std::vector<int64_t>& weight, int shards) {
  int64_t all = 0, before = 0;
  for (const int64_t one : weight) all += one;
  std::vector<uint8_t> owner(weight.size());
  for (size_t c = 0; c < weight.size(); ++c) {
    owner[c] = static_cast<uint8_t>(std::min<int64_t>(shards - 1, before * shards / all));
    before += weight[c];
  }
  return owner;
}

// A small component's cell has no parent. It goes with the coarse cell that its first corners
// follow.
uint8_t owner_of_cell(const HierarchyDepth& depth, size_t cell,
                      const std::vector<uint8_t>& of_parents) {
  if (depth.parent_cell[cell] != kNone) return of_parents[depth.parent_cell[cell]];
  for (const int32_t corner : depth.grid.cell_corners[cell])
    if (const int32_t from = depth.to_parent.prolongation[corner].cell; from != kNone)
      return of_parents[from];
  return 0;  // it floats
}

void lower_to(uint8_t& at, uint8_t value) {
  uint8_t before = __atomic_load_n(&at, __ATOMIC_RELAXED);
  while (before > value && !__atomic_compare_exchange_n(&at, &before, value, true, __ATOMIC_RELAXED,
                                                        __ATOMIC_RELAXED)) {
  }
}

std::vector<uint8_t> owners_of_corners(const SparseGrid& grid, const std::vector<uint8_t>& cell) {
  std::vector<uint8_t> owner(grid.corners.size(), kNobody);
#pragma omp parallel for schedule(static)
  for (size_t c = 0; c < cell.size(); ++c)
    for (const int32_t corner : grid.cell_corners[c]) lower_to(owner[corner], cell[c]);
  return owner;
}

void keep_patches_whole(const SparseGrid& finest, const Patches& patches,
                        std::vector<uint8_t>& owner) {
  DisjointSets joined(patches.count());
  std::vector<int32_t> patch_of_cell(finest.cells.size(), kNone);
  const std::vector<std::vector<int32_t>> sets = patches.corner_sets();
  for (int32_t p = 0; p < patches.count(); ++p)
    for_each_cell_around(finest, sets[p], [&](int32_t cell) {
      if (patch_of_cell[cell] != kNone) joined.join(patch_of_cell[cell], p);
      patch_of_cell[cell] = p;
    });
  for (int32_t p = 0; p < patches.count(); ++p) {
    const uint8_t of_all = owner[sets[joined.root(p)].front()];
    for (const int32_t corner : sets[p]) owner[corner] = of_all;
  }
}

}  // namespace

int border_depth(const Hierarchy& hierarchy, int32_t whole_corners_max) {
  BURNISH_CHECK(hierarchy.finest > hierarchy.coarsest, "only a scan of two depths can be split");
  int border = hierarchy.coarsest;
  while (border + 1 < hierarchy.finest &&
         hierarchy.at(border + 1).grid.corner_count() <= whole_corners_max)
    ++border;
  return border;
}

Cut cut_hierarchy(const Hierarchy& hierarchy, const Patches& patches, int shards, int border) {
  BURNISH_CHECK(shards >= 1 && shards <= kShardsMax, "number of shards");
  Cut cut{.shards = shards, .border = border};
  cut.owners.resize(hierarchy.finest - border + 1);
  cut.owners[0].cell = cut_border(weights_of_border(hierarchy, border), shards);
  cut.owners[0].corner.assign(hierarchy.at(border).grid.corners.size(), 0);
  for (int depth = border + 1; depth <= hierarchy.finest; ++depth) {
    const HierarchyDepth& of = hierarchy.at(depth);
    const std::vector<uint8_t>& of_parents = cut.at(depth - 1).cell;
    Cut::Owners& owners = cut.owners[depth - border];
    owners.cell.resize(of.grid.cells.size());
#pragma omp parallel for schedule(static)
    for (size_t c = 0; c < owners.cell.size(); ++c)
      owners.cell[c] = owner_of_cell(of, c, of_parents);
    owners.corner = owners_of_corners(of.grid, owners.cell);
  }
  if (patches.count() > 0)
    keep_patches_whole(hierarchy.at(hierarchy.finest).grid, patches, cut.owners.back().corner);
  return cut;
}

}  // namespace burnish
