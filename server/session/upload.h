#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "common/base/status.h"
#include "common/service/content_hash.h"

namespace burnish {

/// A file on its way in: every chunk is checked, hashed and written to a staging file, which goes
/// away with this object unless somebody has moved it.
class Upload {
 public:
  /// Fails: as errno says.
  static Result<std::unique_ptr<Upload>> create(const std::filesystem::path& path,
                                                uint64_t size_bytes);
  ~Upload();

  /// Fails: data_loss (gap, damage), invalid_argument (more bytes than announced, chunk size),
  /// resource_exhausted (disk full).
  Status append(uint64_t offset, std::string_view data, uint32_t crc32);

  /// Waits until the bytes are on disk; the SHA-256 of them. Call it once.
  /// Fails: data_loss when bytes are missing.
  Result<std::string> finish();

  const std::filesystem::path& path() const { return path_; }
  uint64_t received_bytes() const { return received_bytes_; }

 private:
  Upload(std::filesystem::path path, int file, uint64_t size_bytes)
      : path_(std::move(path)), file_(file), size_bytes_(size_bytes) {}

  std::filesystem::path path_;
  int file_;
  uint64_t size_bytes_;
  uint64_t received_bytes_ = 0;
  ContentHash hash_;
};

}  // namespace burnish
