#include "server/solver/multi/shard.h"

#include <algorithm>
#include <utility>

#include "common/base/select_numbers.h"
#include "common/base/side_by_side.h"
#include "server/solver/multi/shard_depth.h"

namespace burnish {

namespace {

/// The arrays behind a shard's prepared mesh.
struct Arrays {
  std::vector<MortonKey> cells;
  std::vector<CellIntegrals> integrals;
  std::vector<CellCurvature> curvature;
  std::vector<CellSheet> sheets;
  std::vector<CellIntegrals> sheet_integrals;
  std::vector<EvaluationPoint> evaluation;
};

void take_sheets(const PreparedMesh& whole, const DepthSets& sets, const LocalIndices& local,
                 Arrays& arrays) {
  const auto cells = static_cast<int32_t>(whole.cells.size());
  for (const int32_t part : std::span(sets.parts).subspan(sets.cells)) {
    CellSheet sheet = whole.sheets[part - cells];
    sheet.cell = local.part[sheet.cell];
    arrays.sheets.push_back(sheet);
    arrays.sheet_integrals.push_back(whole.sheet_integrals[part - cells]);
  }
}

// Takes the vertices that lie in the shard's own cells.
void take_vertices(const PreparedMesh& whole, const Cut& cut, int number, const LocalIndices& local,
                   Arrays& arrays, std::vector<int32_t>& vertices) {
  const std::vector<uint8_t>& owner = cut.owners.back().cell;
  vertices = select_numbers(static_cast<int32_t>(whole.evaluation.size()), [&](int32_t v) {
    const int32_t cell = whole.evaluation[v].cell;
    return cell != kNone && owner[cell] == number;
  });
  arrays.evaluation = gather<EvaluationPoint>(whole.evaluation, vertices);
#pragma omp parallel for schedule(static)
  for (size_t i = 0; i < vertices.size(); ++i)
    arrays.evaluation[i].cell = local.part[arrays.evaluation[i].cell];
}

// Has no vertices and no triangles: backends read neither.
std::shared_ptr<const PreparedMesh> with_arrays(const PreparedMesh& whole,
                                                std::shared_ptr<const Arrays> arrays) {
  auto prepared = std::make_shared<PreparedMesh>();
  prepared->frame = whole.frame;
  prepared->length_unit = whole.length_unit;
  prepared->curvature_radius = whole.curvature_radius;
  prepared->statistics = whole.statistics;
  prepared->cells = arrays->cells;
  prepared->integrals = arrays->integrals;
  prepared->curvature = arrays->curvature;
  prepared->sheets = arrays->sheets;
  prepared->sheet_integrals = arrays->sheet_integrals;
  prepared->evaluation = arrays->evaluation;
  prepared->storage = std::move(arrays);
  return prepared;
}

// A colour without patches here stays out: patches of other shards do not touch these.
Patches take_patches(const Patches& whole, const DepthSets& sets, const LocalIndices& local) {
  Patches taken;
  for (int32_t colour = 0; colour < whole.colour_count(); ++colour) {
    const int32_t before = taken.count();
    for (int32_t p = whole.colour_start[colour]; p < whole.colour_start[colour + 1]; ++p) {
      const int32_t first = local.corner[whole.corner[whole.start[p]]];
      if (first == kNone || first >= sets.own) continue;
      for (int32_t k = whole.start[p]; k < whole.start[p + 1]; ++k)
        taken.corner.push_back(local.corner[whole.corner[k]]);
      taken.start.push_back(static_cast<int32_t>(taken.corner.size()));
      taken.entry_start.push_back(taken.entry_count() + whole.entry_start[p + 1] -
                                  whole.entry_start[p]);
    }
    if (taken.count() > before) taken.colour_start.push_back(taken.count());
  }
  return taken;
}

std::shared_ptr<Hierarchy> take_hierarchy(const Hierarchy& whole, const ShardSets& sets,
                                          int number) {
  auto made = std::make_shared<Hierarchy>();
  made->finest = whole.finest;
  made->coarsest = number == 0 ? whole.coarsest : sets.border;
  for (int depth = made->coarsest; depth < sets.border; ++depth)
    made->depths.push_back(whole.at(depth));
  std::vector<LocalIndices> local;
  for (int depth = sets.border; depth <= whole.finest; ++depth)
    local.emplace_back(whole.at(depth), sets.at(depth));
  const auto neighbour = [&](int depth) {
    return NeighbourDepth{whole.at(depth), sets.at(depth), local[depth - sets.border]};
  };
  for (int depth = sets.border; depth <= whole.finest; ++depth) {
    const NeighbourDepth here = neighbour(depth);
    const NeighbourDepth above = neighbour(std::max(depth - 1, sets.border));
    const NeighbourDepth below = neighbour(std::min(depth + 1, whole.finest));
    const bool is_border = depth == sets.border;
    made->depths.push_back(make_shard_depth(here, is_border ? nullptr : &above,
                                            is_border ? nullptr : &made->depths.back().grid,
                                            depth == whole.finest ? nullptr : &below));
    if (is_border && number == 0) {
      made->depths.back().to_parent = whole.at(depth).to_parent;
      made->depths.back().parent_cell = whole.at(depth).parent_cell;
    }
  }
  return made;
}

BorderLists border_lists_of(const DepthSets& border) {
  BorderLists lists;
  for (size_t i = 0; i < border.parts.size(); ++i) {
    if (border.is_made[i] == 0) continue;
    lists.here.push_back(static_cast<int32_t>(i));
    lists.whole.push_back(border.parts[i]);
  }
  return lists;
}

}  // namespace

Shard make_shard(const Multigrid& on, const Cut& cut, int number, const ShardSets& sets,
                 ShardIntegrals integrals) {
  const Hierarchy& whole = *on.hierarchy;
  const DepthSets& finest = sets.depths.back();
  const LocalIndices local(whole.at(whole.finest), finest);
  Shard shard;
  shard.corners = finest.corners;
  shard.own_corners = finest.own;
  shard.cells.assign(finest.parts.begin(), finest.parts.begin() + finest.cells);
  shard.border = border_lists_of(sets.depths.front());

  auto arrays = std::make_shared<Arrays>();
  arrays->cells = gather<MortonKey>(on.prepared->cells, shard.cells);
  if (integrals == ShardIntegrals::kCopied)
    arrays->integrals = gather<CellIntegrals>(on.prepared->integrals, shard.cells);
  arrays->curvature = gather<CellCurvature>(on.prepared->curvature, shard.cells);
  take_sheets(*on.prepared, finest, local, *arrays);
  take_vertices(*on.prepared, cut, number, local, *arrays, shard.vertices);
  shard.on.prepared = with_arrays(*on.prepared, std::move(arrays));

  auto plan = std::make_shared<CyclePlan>(*on.plan);
  plan->patches = take_patches(on.plan->patches, finest, local);
  shard.on.plan = std::move(plan);

  const std::shared_ptr<Hierarchy> hierarchy = take_hierarchy(whole, sets, number);
  hierarchy->points =
      sort_by_cell(shard.on.prepared->evaluation, hierarchy->depths.back().grid.cells.size());
  shard.on.hierarchy = hierarchy;
  return shard;
}

Shards make_shards(const Multigrid& on, int count, int32_t whole_corners_max,
                   ShardIntegrals integrals) {
  const int border = border_depth(*on.hierarchy, whole_corners_max);
  return make_shards(on, cut_hierarchy(*on.hierarchy, on.plan->patches, count, border), integrals);
}

Shards make_shards(const Multigrid& on, const Cut& cut, ShardIntegrals integrals) {
  Shards shards{.border = cut.border};
  shards.all.resize(cut.shards);
  std::vector<ShardSets> sets(cut.shards);
  run_side_by_side(cut.shards, [&](int shard) {
    sets[shard] = find_shard_sets(*on.prepared, *on.hierarchy, cut, shard);
    shards.all[shard] = make_shard(on, cut, shard, sets[shard], integrals);
  });
  for (int depth = shards.border; depth <= on.hierarchy->finest; ++depth) {
    std::vector<HaloLists> lists = find_halo_lists(cut, sets, depth);
    for (int shard = 0; shard < cut.shards; ++shard)
      shards.all[shard].halos.push_back(std::move(lists[shard]));
  }
  return shards;
}

}  // namespace burnish
