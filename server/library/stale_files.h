#pragma once

#include <cstdint>

#include "server/library/data_folder.h"

namespace burnish {

struct RemovedFiles {
  uint64_t count = 0;
  uint64_t bytes = 0;
};

/// Removes prepared files that this server can never use, and says in the log how many and how
/// large: those of another format version, and what a killed server left half written. Whatever
/// does not have the name and the first bytes that a server gives stays, and so do links. (A scan
/// that is removed takes its prepared files along.) Needs: nobody uses the folder's scans.
RemovedFiles remove_stale_files(const DataFolder& folder);

}  // namespace burnish
