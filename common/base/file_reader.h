#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <vector>

#include "common/base/status.h"

namespace burnish {

/// An open regular file whose parts are copied to memory. Unlike a mapping (MappedFile), a read
/// fails when somebody shortens the file. Threads may read at the same time.
class FileReader {
 public:
  /// Fails: not_found, permission_denied, invalid_argument (a directory, a pipe, a device).
  static Result<FileReader> open(const std::filesystem::path& path);
  FileReader(FileReader&& other) noexcept;
  FileReader& operator=(FileReader&& other) noexcept;
  ~FileReader();

  const std::filesystem::path& path() const { return path_; }

  /// Size of the file when it was opened.
  uint64_t file_bytes() const { return file_bytes_; }

  /// Fills `bytes` from an offset. Fails: data_loss (the file ends before); as errno says.
  Status read(uint64_t offset, std::span<uint8_t> bytes) const;
  Result<std::vector<uint8_t>> read(uint64_t offset, size_t size) const;

  /// Fills many bytes by all threads: the system's handing out of their memory takes longer than
  /// the copying. Fails: likewise; cancelled once `goes_on`, which threads call at the same time,
  /// returns false.
  Status read_together(uint64_t offset, std::span<uint8_t> bytes,
                       const std::function<bool()>& goes_on = {}) const;

 private:
  FileReader(int file, std::filesystem::path path) : file_(file), path_(std::move(path)) {}

  int file_ = -1;
  std::filesystem::path path_;
  uint64_t file_bytes_ = 0;
};

}  // namespace burnish
