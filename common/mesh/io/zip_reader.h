#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "common/base/file_budget.h"
#include "common/base/status.h"
#include "common/mesh/triangle_mesh.h"

namespace burnish {

/// Reads the one mesh of an archive, and its textures. Fails: as read_mesh(); as find_mesh().
Result<TriangleMesh> read_zip(std::span<const uint8_t> bytes, const std::string& name,
                              const FileBudget& budget);

/// Returns how much memory read_zip() may take, but for what it asks `budget`. Fails: likewise.
Result<uint64_t> predict_zip_reading_bytes(std::span<const uint8_t> bytes, const std::string& name);

}  // namespace burnish
