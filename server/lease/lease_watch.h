#pragma once

#include <cstddef>
#include <filesystem>
#include <mutex>
#include <vector>

#include "common/base/status.h"

namespace burnish {

/// A file under a lease, and its mapping.
struct FileLease {
  FileLease(int opened, std::filesystem::path copies) : file(opened), folder(std::move(copies)) {}

  const int file;
  const std::filesystem::path folder;  ///< takes the copy
  void* data = nullptr;                ///< the mapping
  size_t size = 0;
};

/// Holds the leases of the process. A thread waits for the kernel's word (SIGIO) that somebody
/// wants to write to a file, and puts a copy in the place of its mapping before it lets go.
class LeaseWatch {
 public:
  static LeaseWatch& instance();

  /// Needs: the file is mapped; give_back() before the lease ends. Fails: failed_precondition, the
  /// kernel gives none.
  Status take(FileLease& lease);

  /// Waits while the lease's bytes are copied.
  void give_back(const FileLease& lease);

 private:
  LeaseWatch();
  void run();

  int wake_;  // an eventfd
  std::mutex mutex_;
  std::vector<FileLease*> leases_;
};

}  // namespace burnish
