#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>

#include "common/base/scratch_space.h"
#include "common/base/status.h"

namespace burnish {

/// A regular file's bytes, copied to scratch space at a multiple of 64 bytes. Unlike a mapping
/// (MappedFile), the copy stays whole when somebody shortens the file.
class FileContent {
 public:
  /// Fails: not_found, permission_denied, invalid_argument (a directory, a pipe, a device);
  /// resource_exhausted (no room in the space); data_loss (the file became shorter while it was
  /// read).
  static Result<FileContent> read(const std::filesystem::path& path,
                                  const ScratchSpace& space = {});

  /// Reads only the first bytes, at most `bytes_max`.
  static Result<FileContent> read_beginning(const std::filesystem::path& path, size_t bytes_max);

  /// Empty for an empty file.
  std::span<const uint8_t> bytes() const {
    return {static_cast<const uint8_t*>(block_.data()), size_};
  }

  /// Size of the whole file when it was opened.
  uint64_t file_bytes() const { return file_bytes_; }

 private:
  FileContent() = default;
  static Result<FileContent> read(const std::filesystem::path& path, size_t bytes_max,
                                  const ScratchSpace& space);

  ScratchBlock block_;
  size_t size_ = 0;
  uint64_t file_bytes_ = 0;
};

}  // namespace burnish
