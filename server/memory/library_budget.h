#pragma once

#include <filesystem>

#include "common/base/scratch_space.h"
#include "common/mesh/mesh_format.h"
#include "server/memory/quota.h"
#include "server/prepare/preparation_need.h"

namespace burnish {

/// The budget of one preparation of the library: a share of the server's memory while this lives,
/// and the disk's free space less a reserve. It also refuses a scan that could never be opened at
/// the depth.
class LibraryBudget : public PreparationBudget {
 public:
  /// Needs: `memory` outlives this. `folder` will hold the prepared file.
  /// `device_bytes_max` is the memory of a device for sessions; 0: sessions take none.
  LibraryBudget(Quota& memory, std::filesystem::path folder, uint64_t device_bytes_max = 0);

  /// Returns room for the scan's arrays and what is made of them: a quarter of the memory that it
  /// may take, then files without names in the folder.
  const ScratchSpace& space() const { return space_; }

  /// Call before reading a mesh file. Fails: resource_exhausted with the numbers; as the file
  /// cannot be opened.
  Status ask_to_read(const std::filesystem::path& file, MeshFormat format);

  /// Call during the reading, before each picture's decoder takes so many bytes. Fails:
  /// resource_exhausted with the numbers.
  Status ask_for_picture(uint64_t bytes);

  uint64_t memory_bytes_max() const override { return bytes_max_; }
  uint64_t default_depth_bytes_max() const override;
  uint64_t scratch_bytes_max() const override;
  Status ask(const PreparationNeed& need) override;

 private:
  Status take(uint64_t bytes);

  static constexpr uint64_t kPartForArrays = 4;  // of the memory; arrays beyond lie in files

  Quota& memory_;
  const std::filesystem::path folder_;
  const uint64_t device_bytes_max_;
  const uint64_t bytes_max_;
  const ScratchSpace space_;
  uint64_t reading_bytes_ = 0;  // without pictures
  Quota::Share share_;
};

/// Fails: resource_exhausted if the file system of `folder` has less than `bytes` free beyond
/// kDiskReserveBytes; as errno says.
Status check_disk_space(const std::filesystem::path& folder, uint64_t bytes);

}  // namespace burnish
