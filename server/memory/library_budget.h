#pragma once

#include <filesystem>

#include "server/memory/quota.h"
#include "server/prepare/preparation_need.h"

namespace burnish {

/// What one preparation of the library may take: a share of the server's memory for as long as this
/// lives, and the disk's free space but for a reserve. A scan that could never be opened at the
/// depth is refused as well.
class LibraryBudget : public PreparationBudget {
 public:
  /// Needs: `memory` outlives this. `folder` is where the prepared file goes.
  LibraryBudget(Quota& memory, std::filesystem::path folder);

  /// Before a mesh file of so many bytes is read. Fails: resource_exhausted with the numbers.
  Status ask_to_read(uint64_t file_bytes);

  uint64_t memory_bytes_max() const override { return bytes_max_; }
  Status ask(const PreparationNeed& need) override;

 private:
  Status take(uint64_t bytes);

  Quota& memory_;
  const std::filesystem::path folder_;
  const uint64_t bytes_max_;
  Quota::Share share_;
};

/// Fails: resource_exhausted when the file system of `folder` has not so many bytes free beside
/// kDiskReserveBytes; as errno says.
Status check_disk_space(const std::filesystem::path& folder, uint64_t bytes);

}  // namespace burnish
