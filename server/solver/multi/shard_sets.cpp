#include "server/solver/multi/shard_sets.h"

#include <algorithm>

#include "common/base/select_numbers.h"
#include "common/base/sort_once.h"
#include "server/solver/hierarchy/half_way.h"
#include "server/solver/hierarchy/sources.h"

namespace burnish {

namespace {

/// A set of indices below a bound. Threads may insert at once.
class MarkedIndices {
 public:
  explicit MarkedIndices(size_t bound) : has_(bound, 0) {}

  void insert(int32_t index) { __atomic_store_n(&has_[index], uint8_t{1}, __ATOMIC_RELAXED); }
  bool contains(int32_t index) const {
    return __atomic_load_n(&has_[index], __ATOMIC_RELAXED) != 0;
  }
  std::vector<int32_t> rising() const {
    return select_numbers(static_cast<int32_t>(has_.size()),
                          [this](int32_t index) { return contains(index); });
  }

 private:
  std::vector<uint8_t> has_;
};

template <typename Visit>
void for_each(std::span<const int32_t> indices, const Visit& visit) {
#pragma omp parallel for schedule(static)
  for (size_t i = 0; i < indices.size(); ++i) visit(indices[i]);
}

// Calls visit(coarse corner) for the corners from which these fine corners are prolonged, from
// several threads.
template <typename Visit>
void visit_prolonged_from(const HierarchyDepth& fine, const HierarchyDepth& coarse,
                          std::span<const int32_t> fine_corners, Visit&& visit) {
  const DepthTransfer& transfer = fine.to_parent;
  for_each(fine_corners, [&](int32_t i) {
    if (!transfer.is_shared(i)) {
      const FromCell from = transfer.prolongation[i];
      const PositiveWeights& weights = positive_weights(from.place);
      for (int k = 0; k < weights.count; ++k)
        visit(coarse.grid.cell_corners[from.cell][weights.corner[k]]);
      return;
    }
    const auto& shared = transfer.shared;
    const auto s = std::ranges::lower_bound(shared.corner, i) - shared.corner.begin();
    for (int32_t k = shared.start[s]; k < shared.start[s + 1]; ++k) visit(shared.coarse_corner[k]);
  });
}

/// Finds the sets of one shard, depth by depth.
class Finder {
 public:
  Finder(const PreparedMesh& prepared, const Hierarchy& hierarchy, const Cut& cut, int shard)
      : prepared_(prepared), hierarchy_(hierarchy), cut_(cut), shard_(shard) {
    found_.border = cut.border;
    found_.depths.resize(hierarchy.finest - cut.border + 1);
  }

  ShardSets find() {
    for (int depth = hierarchy_.finest; depth >= cut_.border; --depth) find_known(depth);
    find_parts_of_border();
    for (int depth = cut_.border + 1; depth <= hierarchy_.finest; ++depth) find_parts(depth);
    for (int depth = cut_.border; depth <= hierarchy_.finest; ++depth) find_fringe(depth);
    return std::move(found_);
  }

 private:
  const HierarchyDepth& whole(int depth) const { return hierarchy_.at(depth); }
  std::span<const int32_t> own_corners(int depth) const {
    return std::span(found_.at(depth).corners).first(found_.at(depth).own);
  }

  void find_known(int depth) {
    const HierarchyDepth& of = whole(depth);
    const Cut::Owners& owners = cut_.at(depth);
    DepthSets& sets = found_.at(depth);
    sets.corners = select_numbers(of.grid.corner_count(),
                                  [&](int32_t i) { return owners.corner[i] == shard_; });
    sets.own = static_cast<int32_t>(sets.corners.size());
    MarkedIndices ghosts(of.grid.corners.size());
    const auto add = [&](int32_t corner) {
      if (owners.corner[corner] != shard_) ghosts.insert(corner);
    };
    if (depth > cut_.border)
      for_each(own_corners(depth), [&](int32_t i) {
        for (auto [k, end] = of.stencil.row(i); k < end; ++k) add(of.stencil.column[k]);
      });
    if (depth == hierarchy_.finest)  // vertices lie in own cells
      for_each(
          select_numbers(of.grid.cell_count(), [&](int32_t c) { return owners.cell[c] == shard_; }),
          [&](int32_t c) { std::ranges::for_each(of.grid.cell_corners[c], add); });
    if (depth < hierarchy_.finest)
      visit_prolonged_from(whole(depth + 1), of, own_corners(depth + 1), add);
    const std::vector<int32_t> found = ghosts.rising();
    sets.ghosts = static_cast<int32_t>(found.size());
    sets.corners.insert(sets.corners.end(), found.begin(), found.end());
  }

  // A tie belongs to the owner of its first cell.
  bool makes_part_of_border(int32_t part) const {
    const HierarchyDepth& border = whole(cut_.border);
    const int32_t tie = part - border.grid.cell_count();
    return cut_.owners[0].cell[tie < 0 ? part : border.ties[tie].first] == shard_;
  }

  void find_parts_of_border() {
    const HierarchyDepth& border = whole(cut_.border);
    MarkedIndices parts(part_count(border));
    for (int32_t part = 0; part < static_cast<int32_t>(part_count(border)); ++part)
      if (shard_ == 0 || makes_part_of_border(part)) parts.insert(part);
    const HierarchyDepth& fine = whole(cut_.border + 1);
    for (const int32_t i : own_corners(cut_.border + 1))
      if (!fine.to_parent.is_shared(i)) parts.insert(fine.to_parent.prolongation[i].cell);
    insert_cells_of_parts(border, parts);
    set_parts(cut_.border, parts.rising());
    DepthSets& sets = found_.at(cut_.border);
    for (size_t i = 0; i < sets.parts.size(); ++i)
      sets.is_made[i] = makes_part_of_border(sets.parts[i]);
  }

  void find_parts(int depth) {
    const HierarchyDepth& of = whole(depth);
    MarkedIndices parts(part_count(of));
    const auto insert = [&](int32_t part) { parts.insert(part); };
    for_each(found_.at(depth).corners,
             [&](int32_t corner) { visit_parts_of_row(of, corner, insert); });
    const DepthSets& above = found_.at(depth - 1);
#pragma omp parallel for schedule(static)
    for (size_t i = 0; i < above.parts.size(); ++i)
      if (above.is_made[i] != 0) visit_sources(whole(depth - 1), above.parts[i], insert);
    insert_cells_of_parts(of, parts);
    set_parts(depth, parts.rising());
  }

  // Inserts the cells that ties couple, and those of sheets.
  void insert_cells_of_parts(const HierarchyDepth& of, MarkedIndices& parts) const {
    const int32_t cells = of.grid.cell_count();
    for (size_t t = 0; t < of.ties.size(); ++t)
      if (parts.contains(cells + static_cast<int32_t>(t))) {
        parts.insert(of.ties[t].first);
        parts.insert(of.ties[t].second);
      }
    for (int32_t s = 0; s < of.sheet_count; ++s)
      if (parts.contains(cells + s)) parts.insert(prepared_.sheets[s].cell);
  }

  void set_parts(int depth, std::vector<int32_t> parts) {
    DepthSets& sets = found_.at(depth);
    sets.cells = static_cast<int32_t>(
        std::ranges::lower_bound(parts, whole(depth).grid.cell_count()) - parts.begin());
    sets.parts = std::move(parts);
    sets.is_made.assign(sets.parts.size(), 1);
  }

  void find_fringe(int depth) {
    const SparseGrid& grid = whole(depth).grid;
    DepthSets& sets = found_.at(depth);
    MarkedIndices known(grid.corners.size()), fringe(grid.corners.size());
    for_each(sets.corners, [&](int32_t corner) { known.insert(corner); });
    for_each(std::span(sets.parts).first(sets.cells), [&](int32_t cell) {
      for (const int32_t corner : grid.cell_corners[cell])
        if (!known.contains(corner)) fringe.insert(corner);
    });
    const std::vector<int32_t> found = fringe.rising();
    sets.corners.insert(sets.corners.end(), found.begin(), found.end());
  }

  const PreparedMesh& prepared_;
  const Hierarchy& hierarchy_;
  const Cut& cut_;
  const int shard_;
  ShardSets found_;
};

}  // namespace

ShardSets find_shard_sets(const PreparedMesh& prepared, const Hierarchy& hierarchy, const Cut& cut,
                          int shard) {
  return Finder(prepared, hierarchy, cut, shard).find();
}

std::vector<HaloLists> find_halo_lists(const Cut& cut, const std::vector<ShardSets>& shards,
                                       int depth) {
  const std::vector<uint8_t>& owner = cut.at(depth).corner;
  const auto own_of = [&](int shard) {
    const DepthSets& sets = shards[shard].at(depth);
    return std::span(sets.corners).first(sets.own);
  };
  const auto ghosts_of = [&](int shard) {
    const DepthSets& sets = shards[shard].at(depth);
    return std::span(sets.corners).subspan(sets.own, sets.ghosts);
  };
  std::vector<std::vector<int32_t>> sent(cut.shards);  // in the whole depth
  for (int shard = 0; shard < cut.shards; ++shard)
    for (const int32_t ghost : ghosts_of(shard)) sent[owner[ghost]].push_back(ghost);
  std::vector<HaloLists> lists(cut.shards);
  for (int shard = 0; shard < cut.shards; ++shard) {
    sort_once(sent[shard]);
    const auto own = own_of(shard);
    for (const int32_t corner : sent[shard])
      lists[shard].sent.push_back(
          static_cast<int32_t>(std::ranges::lower_bound(own, corner) - own.begin()));
  }
  for (int shard = 0; shard < cut.shards; ++shard)
    for (const int32_t ghost : ghosts_of(shard)) {
      const auto& of_owner = sent[owner[ghost]];
      lists[shard].ghosts.push_back(
          {owner[ghost],
           static_cast<int32_t>(std::ranges::lower_bound(of_owner, ghost) - of_owner.begin())});
    }
  for (int shard = 0; shard < cut.shards; ++shard)
    lists[shard].copies = group_by<HaloLists::Place>(sent[shard].size(), [&](auto&& add) {
      for (int other = 0; other < cut.shards; ++other)
        for (size_t i = 0; i < lists[other].ghosts.size(); ++i)
          if (lists[other].ghosts[i].shard == shard)
            add(lists[other].ghosts[i].index, HaloLists::Place{other, static_cast<int32_t>(i)});
    });
  return lists;
}

}  // namespace burnish
