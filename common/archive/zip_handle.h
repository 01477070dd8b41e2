#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <zip.h>

#include "common/base/status.h"

namespace burnish {

/// Private to this folder: libzip's objects, and its errors as ours.

/// Closes an archive without writing it.
struct DiscardZip {
  void operator()(zip_t* archive) const { zip_discard(archive); }
};
using ZipHandle = std::unique_ptr<zip_t, DiscardZip>;

/// Closes an entry that is being read.
struct CloseZipFile {
  void operator()(zip_file_t* file) const { zip_fclose(file); }
};
using ZipFile = std::unique_ptr<zip_file_t, CloseZipFile>;

/// Releases one reference to a source.
struct FreeZipSource {
  void operator()(zip_source_t* source) const { zip_source_free(source); }
};
using ZipSource = std::unique_ptr<zip_source_t, FreeZipSource>;

/// Makes a source of bytes that outlive it. Fails: resource_exhausted.
Result<ZipSource> source_of(std::span<const uint8_t> bytes);

/// Opens the archive in `source`, which stays the caller's. `flags` are libzip's.
/// Fails: invalid_argument (damaged), resource_exhausted.
Result<ZipHandle> open_zip(const ZipSource& source, int flags);

/// Returns libzip's error as a Status: invalid_argument, or resource_exhausted.
Status zip_status(zip_error_t* error);

}  // namespace burnish
