#include "server/solver/cpu/cpu_depth.h"

namespace burnish::cpu {

CpuDepth::CpuDepth(const HierarchyDepth& topology_of_depth, Halo* halo_of_depth)
    : topology(topology_of_depth),
      halo(halo_of_depth),
      system(topology.stencil),
      inverse_diagonal(topology.grid.corners.size()),
      x(topology.grid.corners.size(), Float4::Zero()),
      f(topology.grid.corners.size(), Float4::Zero()),
      r(topology.grid.corners.size(), Float4::Zero()) {}

uint64_t CpuDepth::byte_count() const {
  return system.byte_count() + bytes_of(inverse_diagonal) + bytes_of(kept_numbers) + bytes_of(x) +
         bytes_of(f) + bytes_of(r);
}

}  // namespace burnish::cpu
