#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "common/base/atomic_file.h"
#include "common/base/status.h"
#include "common/transfer/content_hash.h"
#include "server/memory/quota.h"
#include "server/metrics/live_objects.h"

namespace burnish {

/// A file on its way in. Every chunk is checked, hashed and written to a staging file. The file is
/// deleted with this object unless it was moved.
class Upload {
 public:
  /// Fails: as errno says.
  static Result<std::unique_ptr<Upload>> create(const std::filesystem::path& path,
                                                uint64_t size_bytes, Quota::Share share = {});
  ~Upload();

  /// Fails: data_loss (gap, damage), invalid_argument (more bytes than announced, chunk size),
  /// resource_exhausted (disk full).
  Status append(uint64_t offset, std::string_view data, uint32_t crc32);

  /// Puts the bytes at path(), on disk. Returns their SHA-256. Call it once. Fails: data_loss if
  /// bytes are missing.
  Result<std::string> finish();

  const std::filesystem::path& path() const { return path_; }
  uint64_t received_bytes() const { return received_bytes_; }
  uint64_t size_bytes() const { return size_bytes_; }

 private:
  Upload(std::filesystem::path path, AtomicFile file, uint64_t size_bytes, Quota::Share share)
      : path_(std::move(path)),
        file_(std::move(file)),
        size_bytes_(size_bytes),
        share_(std::move(share)) {}

  std::filesystem::path path_;
  AtomicFile file_;
  uint64_t size_bytes_;
  Quota::Share share_;  // of the bytes that its user may have in uploads
  uint64_t received_bytes_ = 0;
  ContentHash hash_;
  LiveObject live_{LiveKind::kUpload};
};

}  // namespace burnish
