#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "common/base/file_budget.h"
#include "common/base/status.h"

namespace burnish {

/// A file on its way into an archive.
struct FileToPack {
  std::string name;                ///< a path that check_entry_name() takes
  std::span<const uint8_t> bytes;  ///< outlives the packing
};

/// Returns whether a file's name says that its bytes are compressed already: .png, .jpg, .glb ...
bool is_compressed_by_name(std::string_view name);

/// Packs files in their order. The same files give the same bytes: each has the time 1980-01-01.
/// Compressed files are stored as they are. Fails: invalid_argument (a name), resource_exhausted;
/// cancelled, as `budget` says.
Result<std::vector<uint8_t>> pack_archive(std::span<const FileToPack> files,
                                          const FileBudget& budget = {});

/// An entry's new bytes.
struct ChangedEntry {
  size_t entry = 0;
  std::span<const uint8_t> bytes;  ///< outlives the packing
};

/// Returns an archive with other bytes in some entries. All other entries keep their packed bytes,
/// names, times and order; a changed one keeps its name, time and method of packing.
/// Needs: Archive::open() took the archive, and the entries are files in it. Fails: as it does;
/// cancelled, as `budget` says.
Result<std::vector<uint8_t>> replace_entries(std::span<const uint8_t> archive,
                                             std::span<const ChangedEntry> changed,
                                             const FileBudget& budget = {});

}  // namespace burnish
