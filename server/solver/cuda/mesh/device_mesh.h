#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "server/solver/cuda/device/device_memory.h"
#include "server/solver/cuda/device/views.h"
#include "server/solver/cuda/mesh/device_irregular.h"
#include "server/solver/cuda/mesh/device_patches.h"
#include "server/solver/cuda/mesh/device_shares.h"
#include "server/solver/cuda/mesh/device_transfer.h"
#include "server/solver/cycle/multigrid.h"
#include "server/solver/hierarchy/touched_blocks.h"

namespace burnish::cuda {

/// One depth's stencil and transfers on the device.
class DeviceTopology {
 public:
  DeviceTopology(Stream& stream, const HierarchyDepth& depth, const CyclePlan& plan);

  const Topology& view() const { return view_; }
  uint64_t byte_count() const;

 private:
  DeviceArray<int64_t> slice_start_;
  DeviceArray<uint32_t> mask_;
  DeviceArray<uint16_t> local_;
  DeviceArray<int32_t> halo_start_, halo_, child_start_, child_;
  DeviceArray<Eight> cell_corners_, cells_of_corner_;
  DeviceArray<uint8_t> octant_, is_exact_;
  DeviceIrregular irregular_;
  DeviceShares shares_;
  DeviceTransfer transfer_;
  Topology view_{};
};

/// The integrals of some cells of a scan.
struct IntegralsOfCells {
  std::span<const CellIntegrals> all;
  std::optional<std::span<const int32_t>> cells = {};  ///< of these; none: all

  size_t size() const { return cells ? cells->size() : all.size(); }
  const CellIntegrals& operator[](size_t i) const { return all[cells ? (*cells)[i] : i]; }
};

/// The PreparedMesh::sheets that a hierarchy uses, on the device.
class DeviceSheets {
 public:
  DeviceSheets() = default;
  DeviceSheets(Stream& stream, const PreparedMesh& prepared, int32_t count);

  SheetIntegrals view() const {
    return {{numbers_.data(), static_cast<int64_t>(cell_.size())}, cell_.data()};
  }
  uint64_t byte_count() const { return numbers_.byte_count() + cell_.byte_count(); }

 private:
  DeviceArray<double> numbers_;
  DeviceArray<int32_t> cell_;
};

/// The part of a prepared mesh that no edit changes. Immutable; its sessions share it.
struct DeviceMesh {
  int device = 0;
  Multigrid on;
  std::vector<DeviceTopology> depths;  ///< the coarsest first
  DeviceArray<double> integral_numbers;
  DeviceSheets sheets;
  DevicePatches patches;
  DeviceArray<Curvature> curvature;
  DeviceArray<VertexPlace> evaluation;
  /// Says what local new metrics touch; on the host. A shard has none: other shards change what it
  /// does not know of. Nor has a mesh of one depth.
  std::optional<BlockReach> reach;

  int64_t cells() const { return depths.back().view().cell_count; }
  Integrals integrals() const { return {integral_numbers.data(), cells()}; }
  uint64_t byte_count() const;

  /// Leaves of `on` what a backend that is made asks for: its plan, its frame and its depths'
  /// numbers, not their arrays.
  void forget_arrays();
};

/// Copies the mesh to a device, or returns another session's copy there. Fails: resource_exhausted,
/// internal.
Result<std::shared_ptr<const DeviceMesh>> device_mesh(int device, Multigrid on);

/// Copies a shard's mesh with its cells' integrals, and keeps none of the prepared mesh on the
/// host. Fails likewise.
Result<std::shared_ptr<DeviceMesh>> device_mesh_of_shard(int device, Multigrid on,
                                                         const IntegralsOfCells& integrals);

}  // namespace burnish::cuda
