#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>

#include "common/base/status.h"

namespace burnish {

/// A regular file's bytes, mapped for reading while this object lives. The kernel loads a page when
/// it is touched, so opening costs nothing, and the kernel can drop pages when memory is short.
/// Needs: nobody shortens the file meanwhile. AtomicFile never does: it renames.
class MappedFile {
 public:
  /// Fails: not_found, permission_denied, invalid_argument (a directory, a pipe, a device).
  static Result<MappedFile> open(const std::filesystem::path& path);

  MappedFile(MappedFile&& other) noexcept;
  MappedFile& operator=(MappedFile&& other) noexcept;
  ~MappedFile();

  /// Empty for an empty file.
  std::span<const uint8_t> bytes() const { return {data_, size_}; }

 private:
  MappedFile() = default;

  const uint8_t* data_ = nullptr;
  size_t size_ = 0;
};

}  // namespace burnish
