#include "server/solver/cuda/mesh/device_mesh.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <mutex>
#include <tuple>

#include "server/solver/cuda/mesh/long_rows.h"
#include "server/solver/cuda/mesh/mass_places.h"
#include "server/solver/cuda/mesh/row_groups.h"

namespace burnish::cuda {

static_assert(offsetof(VertexPlace, local) == offsetof(EvaluationPoint, local));

static std::vector<uint8_t> octants(const SparseGrid& grid) {
  std::vector<uint8_t> octants(grid.cells.size());
#pragma omp parallel for schedule(static)
  for (size_t c = 0; c < octants.size(); ++c) octants[c] = grid.cells[c].place & 7;
  return octants;
}

// Returns masks that count only the packed entries of irregular rows.
static std::vector<uint32_t> masks_of_packed(const Stencil& stencil) {
  std::vector<uint32_t> masks = stencil.mask;
  for (const int32_t i : stencil.irregular.corner) {
    const Stencil::Row row = packed_part(stencil, i);
    masks[i] = ((1u << (row.end - row.begin)) - 1) << (kSlots - (row.end - row.begin));
  }
  return masks;
}

// Finds groups with flat pieces, or with a piece that hangs on another by a sliver: their
// eigenvalues are below the rounding of packed entries. Returns an empty list if no group has such
// a piece.
static std::vector<uint8_t> groups_that_need_all_digits(const HierarchyDepth& depth,
                                                        const CyclePlan& plan,
                                                        const RowGroups& groups) {
  const bool is_weak = plan.needs_all_digits(depth.grid.depth);
  const bool has_patches = depth.is_finest() && plan.patches.count() > 0;
  if (!has_patches && !is_weak) return {};
  std::vector<uint8_t> has_weak(groups.halo_start.size() - 1, is_weak);
  if (has_patches)
    for (const int32_t corner : plan.patches.corner) has_weak[corner / groups.rows] = 1;
  return has_weak;
}

DeviceTopology::DeviceTopology(Stream& stream, const HierarchyDepth& depth, const CyclePlan& plan)
    : irregular_(stream, depth.stencil, depth.grid.cell_count()),
      shares_(stream, depth),
      transfer_(stream, depth.to_parent) {
  const std::vector<int64_t> starts = slice_starts(depth.stencil);
  slice_start_ = {stream, starts};
  mask_ = {stream, masks_of_packed(depth.stencil)};
  const RowGroups groups = make_row_groups(depth.stencil, starts);
  local_ = {stream, groups.local};
  halo_start_ = {stream, groups.halo_start};
  halo_ = {stream, groups.halo};
  is_exact_ = {stream, groups_that_need_all_digits(depth, plan, groups)};
  cell_corners_ = DeviceArray<Eight>::copy_of(stream, depth.grid.cell_corners);
  cells_of_corner_ = DeviceArray<Eight>::copy_of(stream, depth.grid.cells_of_corner);
  octant_ = {stream, octants(depth.grid)};
  child_start_ = {stream, depth.children.start};
  child_ = {stream, depth.children.item};
  view_.corner_count = depth.grid.corner_count();
  view_.cell_count = depth.grid.cell_count();
  view_.number_count = static_cast<int64_t>(depth.number_count());
  view_.entry_count = starts.back();
  view_.rows = {depth.grid.corner_count(),
                slice_start_.data(),
                mask_.data(),
                local_.data(),
                groups.rows,
                groups.tile_max,
                static_cast<int32_t>(groups.halo_start.size()) - 1,
                halo_start_.data(),
                halo_.data(),
                irregular_.long_rows(),
                (depth.own_count() + groups.rows - 1) / groups.rows};
  view_.cell_corners = cell_corners_.data();
  view_.cells_of_corner = cells_of_corner_.data();
  view_.octant = octant_.data();
  view_.child_start = child_start_.data();
  view_.child = child_.data();
  view_.irregular = irregular_.view();
  view_.shares = shares_.view();
  view_.is_exact = is_exact_.data();
  view_.own_count = depth.own_count();
  view_.known_count = depth.known_count();
  transfer_.put_into(view_);
}

uint64_t DeviceTopology::byte_count() const {
  return slice_start_.byte_count() + mask_.byte_count() + local_.byte_count() +
         halo_start_.byte_count() + halo_.byte_count() + child_start_.byte_count() +
         child_.byte_count() + cell_corners_.byte_count() + cells_of_corner_.byte_count() +
         octant_.byte_count() + is_exact_.byte_count() + irregular_.byte_count() +
         shares_.byte_count() + transfer_.byte_count();
}

uint64_t DeviceMesh::byte_count() const {
  uint64_t bytes = integral_numbers.byte_count() + curvature.byte_count() +
                   evaluation.byte_count() + sheets.byte_count() + patches.byte_count();
  for (const DeviceTopology& depth : depths) bytes += depth.byte_count();
  return bytes;
}

static std::array<double, Integrals::kNumbers> numbers_of(const CellIntegrals& of) {
  constexpr MassPlaces kPlaces = mass_places();
  std::array<double, Integrals::kNumbers> numbers;
  auto next = numbers.begin();
  for (const uint8_t pair : kPlaces.first_pair) *next++ = of.mass[pair];
  next = std::ranges::copy(of.mass_row_sum, next).out;
  for (const auto& stiffness : of.stiffness) next = std::ranges::copy(stiffness, next).out;
  return numbers;
}

// Copies cells in pieces: the numbers of a large scan's cells take as much as all the rest of it.
static DeviceArray<double> numbers_on_device(Stream& stream, const IntegralsOfCells& integrals) {
  constexpr size_t kPiece = size_t{1} << 16;  // cells; a host's cores take turns with the bus
  const size_t cells = integrals.size(), width = std::min(kPiece, cells);
  if (cells == 0) return {};
  DeviceArray<double> numbers(stream, Integrals::kNumbers * cells);
  const PinnedArray<double> piece(stream, Integrals::kNumbers * width);
  for (size_t first = 0; first < cells && stream.is_ok(); first += width) {
    const size_t count = std::min(width, cells - first);
#pragma omp parallel for schedule(static)
    for (size_t c = 0; c < count; ++c) {
      const auto of_cell = numbers_of(integrals[first + c]);
      for (size_t i = 0; i < of_cell.size(); ++i) piece.data()[i * width + c] = of_cell[i];
    }
    upload_rows(stream, numbers.data() + first, cells, piece.data(), width,
                {count, Integrals::kNumbers});
    stream.synchronize();
  }
  return numbers;
}

DeviceSheets::DeviceSheets(Stream& stream, const PreparedMesh& prepared, int32_t count) {
  std::vector<int32_t> cells;
  for (const CellSheet& sheet : prepared.sheets.first(count)) cells.push_back(sheet.cell);
  cell_ = {stream, cells};
  numbers_ = numbers_on_device(stream, {prepared.sheet_integrals.first(count)});
}

static std::vector<Curvature> curvatures(std::span<const CellCurvature> of_cells) {
  std::vector<Curvature> curvatures(of_cells.size());
#pragma omp parallel for schedule(static)
  for (size_t c = 0; c < of_cells.size(); ++c)
    curvatures[c] = {of_cells[c].kappa1, of_cells[c].kappa2};
  return curvatures;
}

static Result<std::shared_ptr<DeviceMesh>> copy_to_device(int device, Multigrid on,
                                                          const IntegralsOfCells& integrals) {
  Stream stream(device);
  auto mesh = std::make_shared<DeviceMesh>();
  mesh->device = device;
  const PreparedMesh& prepared = *on.prepared;
  for (const HierarchyDepth& depth : on.hierarchy->depths)
    mesh->depths.emplace_back(stream, depth, *on.plan);
  mesh->integral_numbers = numbers_on_device(stream, integrals);
  mesh->sheets = {stream, prepared, on.hierarchy->depths.back().sheet_count};
  mesh->patches = {stream, on.plan->patches};
  mesh->curvature = {stream, curvatures(prepared.curvature)};
  mesh->evaluation = DeviceArray<VertexPlace>::copy_of(stream, prepared.evaluation);
  mesh->on = std::move(on);
  if (!stream.synchronize()) return stream.status();
  return mesh;
}

static std::shared_ptr<const PreparedMesh> without_arrays(const PreparedMesh& of) {
  const auto prepared = std::make_shared<PreparedMesh>();
  prepared->frame = of.frame;
  prepared->length_unit = of.length_unit;
  return prepared;
}

Result<std::shared_ptr<DeviceMesh>> device_mesh_of_shard(int device, Multigrid on,
                                                         const IntegralsOfCells& integrals) {
  ASSIGN_OR_RETURN(auto mesh, copy_to_device(device, std::move(on), integrals));
  mesh->on.prepared = without_arrays(*mesh->on.prepared);
  return mesh;
}

void DeviceMesh::forget_arrays() {
  const auto depths_alone = std::make_shared<Hierarchy>();
  depths_alone->coarsest = on.hierarchy->coarsest;
  depths_alone->finest = on.hierarchy->finest;
  on.hierarchy = depths_alone;
  on.prepared = without_arrays(*on.prepared);
}

static std::optional<BlockReach> find_reach(const DeviceMesh& mesh) {
  if (mesh.depths.size() < 2) return std::nullopt;
  std::vector<int32_t> rows_of_block;
  for (const DeviceTopology& depth : mesh.depths)
    rows_of_block.push_back(depth.view().rows.group_rows);
  return BlockReach(*mesh.on.prepared, *mesh.on.hierarchy, rows_of_block);
}

// The mesh keeps hierarchy and plan alive, so their addresses identify them while it lives.
Result<std::shared_ptr<const DeviceMesh>> device_mesh(int device, Multigrid on) {
  static std::mutex mutex;
  using Key = std::tuple<int, const Hierarchy*, const CyclePlan*>;
  static std::map<Key, std::weak_ptr<const DeviceMesh>> meshes;
  const std::scoped_lock lock(mutex);
  std::erase_if(meshes, [](const auto& entry) { return entry.second.expired(); });
  const Key key = {device, on.hierarchy.get(), on.plan.get()};
  if (const auto found = meshes.find(key); found != meshes.end())
    if (auto mesh = found->second.lock()) return mesh;
  const IntegralsOfCells integrals = {on.prepared->integrals};
  ASSIGN_OR_RETURN(auto made, copy_to_device(device, std::move(on), integrals));
  made->reach = find_reach(*made);
  std::shared_ptr<const DeviceMesh> mesh = std::move(made);
  meshes[key] = mesh;
  return mesh;
}

}  // namespace burnish::cuda
