#pragma once

#include <cstdint>

#include "server/library/data_folder.h"

namespace burnish {

struct RemovedFiles {
  uint64_t count = 0;
  uint64_t bytes = 0;
};

/// Removes prepared files that this server can never use, and logs their number and size: files of
/// another format version, and half-written files of a killed server. Other names, other first
/// bytes and links stay. (Removing a scan also removes its prepared files.) Needs: nobody uses the
/// folder's scans.
RemovedFiles remove_stale_files(const DataFolder& folder);

}  // namespace burnish
