#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>

#include "common/base/status.h"

namespace burnish {

struct FileLease;

/// A file's bytes, mapped for reading, that stay as they are whatever others do to the file. The
/// kernel holds up who opens it for writing, or shortens it (a read lease, fcntl(2)), until the
/// bytes are copied to a file without a name, whose mapping takes the place of the first. So
/// opening copies nothing. From the first lease on the process's SIGIO belongs to this class.
class LeasedFile {
 public:
  /// `folder` takes the copy; where it has no room, memory does. Fails: failed_precondition (the
  /// file system has no leases, the file is empty, another user's, or open for writing);
  /// otherwise as FileReader::open().
  static Result<LeasedFile> open(const std::filesystem::path& path, std::filesystem::path folder);

  LeasedFile(LeasedFile&& other) noexcept;
  LeasedFile& operator=(LeasedFile&& other) noexcept;
  ~LeasedFile();  ///< waits while the bytes are copied

  std::span<const uint8_t> bytes() const;

 private:
  explicit LeasedFile(std::unique_ptr<FileLease> lease);

  std::unique_ptr<FileLease> lease_;
};

}  // namespace burnish
