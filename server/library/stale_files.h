#pragma once

#include <cstdint>

#include "server/library/data_folder.h"

namespace burnish {

struct RemovedFiles {
  uint64_t count = 0;
  uint64_t bytes = 0;
};

/// Removes prepared files, hierarchies, page files and sheet files that this server can never use:
/// files of another format version, and files that a killed server left half written. Logs their
/// number and size. Keeps links, and every file without the name and the first bytes that a server
/// gives. Needs: nobody uses the folder's scans.
RemovedFiles remove_stale_files(const DataFolder& folder);

}  // namespace burnish
