#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>

#include "common/base/progress.h"
#include "common/base/status.h"
#include "server/solver/cycle/multigrid.h"

namespace burnish {

/// Returns what a hierarchy file says that it was made from: the prepared file with this checksum
/// in its header, by this release of the program.
uint64_t hierarchy_fingerprint(uint64_t prepared_checksum);

/// Returns the bytes that write_hierarchy() puts into a file.
uint64_t hierarchy_file_bytes(const Multigrid& of);

/// Writes the hierarchy and the plan to `path` through a synced temporary file. The same ones give
/// the same bytes. Fails: cancelled; as errno says.
Status write_hierarchy(const Multigrid& of, uint64_t fingerprint, const std::filesystem::path& path,
                       const Progress& progress = {});

/// Reads into memory what write_hierarchy() wrote of `prepared`, by all threads: the bits that
/// make_multigrid() would make. The file itself is not mapped: that would end the process when
/// somebody shortens it. Fails: not_found; data_loss that names the section when version,
/// fingerprint, a size, a checksum or an index is wrong; cancelled. Throws: bad_alloc.
Result<Multigrid> read_hierarchy(const std::filesystem::path& path,
                                 std::shared_ptr<const PreparedMesh> prepared, uint64_t fingerprint,
                                 const Progress& progress = {});

/// Raise this when the format changes, or when make_hierarchy() or plan_cycle() give other bits.
inline constexpr uint32_t kHierarchyFormatVersion = 1;

}  // namespace burnish
