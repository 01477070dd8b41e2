#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>

#include "common/base/status.h"

namespace burnish {

/// A regular file's bytes, copied to memory at a multiple of 64 bytes. Unlike a mapping
/// (MappedFile), the copy stays whole when somebody shortens the file.
class FileContent {
 public:
  /// Fails: not_found, permission_denied, invalid_argument (a directory, a pipe, a device);
  /// resource_exhausted (not enough memory); data_loss (the file became shorter while it was read).
  static Result<FileContent> read(const std::filesystem::path& path);

  /// Reads only the first bytes, at most `bytes_max`.
  static Result<FileContent> read_beginning(const std::filesystem::path& path, size_t bytes_max);

  /// Empty for an empty file.
  std::span<const uint8_t> bytes() const { return {data_.get(), size_}; }

  /// Size of the whole file when it was opened.
  uint64_t file_bytes() const { return file_bytes_; }

 private:
  struct Free {
    void operator()(uint8_t* data) const;
  };

  FileContent() = default;
  static Result<FileContent> allocate(size_t size, const std::filesystem::path& path);

  std::unique_ptr<uint8_t, Free> data_;
  size_t size_ = 0;
  uint64_t file_bytes_ = 0;
};

}  // namespace burnish
