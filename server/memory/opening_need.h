#pragma once

#include <cstdint>

#include "server/prepare/preparation_need.h"
#include "server/prepare/prepared_mesh.h"

namespace burnish {

/// The place of the data of a prepared mesh.
enum class PreparedPlace {
  kMemory,
  kFile,  ///< a mapped file without a name: the kernel drops from memory what nobody reads
};

/// Returns the place of a prepared mesh of so many bytes, if the disk has room. Frames read little
/// of it: a new metric reads the integrals, an export the vertices.
PreparedPlace place_of_prepared(uint64_t bytes);

/// Returns the bytes of memory that a prepared mesh and its hierarchy will take together. Works
/// before the hierarchy is made.
uint64_t predict_mesh_bytes(const PreparedMesh& prepared, PreparedPlace place);
uint64_t predict_mesh_bytes(const PreparedSummary& prepared, PreparedPlace place);

/// Returns the bytes of the host's memory that a prepared mesh and one session over it will take at
/// least. Works before the mesh is prepared. `device_bytes_max`: memory of all devices for
/// sessions. Accuracy: no more than their opening is admitted with, so that nobody is refused
/// wrongly.
uint64_t predict_opened_bytes(const PreparationNeed& need, uint64_t device_bytes_max);

}  // namespace burnish
