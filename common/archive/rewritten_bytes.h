#pragma once

#include <cstdint>
#include <span>
#include <vector>
#include <zip.h>

#include "common/archive/zip_handle.h"
#include "common/base/status.h"

namespace burnish {

/// Private to this folder: bytes that libzip reads as an archive, and the archive that it writes in
/// their place. It writes all of it anew: when libzip 1.7 keeps an unchanged beginning in a buffer
/// of its own kind, it frees memory of the caller.
class RewrittenBytes {
 public:
  /// Needs: `before` outlives this.
  explicit RewrittenBytes(std::span<const uint8_t> before) : before_(before) {
    zip_error_init(&error_);
  }
  ~RewrittenBytes() { zip_error_fini(&error_); }
  RewrittenBytes(const RewrittenBytes&) = delete;
  RewrittenBytes& operator=(const RewrittenBytes&) = delete;

  /// Makes a source of the bytes. Needs: this outlives it. Fails: resource_exhausted.
  Result<ZipSource> source();

  /// Returns what was written. Needs: libzip has closed the archive.
  std::vector<uint8_t> take() { return std::move(after_); }

 private:
  static zip_int64_t serve(void* self, void* data, zip_uint64_t bytes, zip_source_cmd_t command);
  zip_int64_t answer(void* data, zip_uint64_t bytes, zip_source_cmd_t command);
  zip_int64_t tell_size(void* data, zip_uint64_t bytes);
  zip_int64_t read(void* data, zip_uint64_t bytes);
  zip_int64_t write(const void* data, zip_uint64_t bytes);
  zip_int64_t seek(uint64_t& place, uint64_t size, void* data, zip_uint64_t bytes);
  zip_int64_t start_writing();

  std::span<const uint8_t> before_;
  std::vector<uint8_t> after_;
  uint64_t read_place_ = 0;
  uint64_t write_place_ = 0;
  zip_error_t error_;
};

}  // namespace burnish
