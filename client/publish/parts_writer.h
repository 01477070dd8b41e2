#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "common/base/atomic_file.h"
#include "common/transfer/content_hash.h"

namespace burnish {

/// Names of the two files of parts, without folders.
struct PartsFiles {
  std::string parts;  ///< the parts one behind the other
  std::string index;  ///< the length of each in bytes, u32, little-endian
};

/// Writes the parts that a reader asks for by ranges, and their index. A part's place is the sum of
/// the lengths before it. The names have a hash of the content, so a file never changes and an old
/// index never meets new parts.
class PartsWriter {
 public:
  /// Fails: as AtomicFile::create().
  static Result<PartsWriter> create(const std::filesystem::path& folder);

  /// Appends a part, which may be empty. Fails: resource_exhausted (the disk).
  Status add(std::string_view part);

  uint64_t byte_count() const { return bytes_; }
  size_t part_count() const { return lengths_.size(); }

  /// Writes the index and gives both files their names. Call once, last. Fails: as writing does.
  Result<PartsFiles> finish();

 private:
  PartsWriter(std::filesystem::path folder, AtomicFile file);

  std::filesystem::path folder_;
  AtomicFile file_;
  ContentHash hash_;
  std::vector<uint32_t> lengths_;
  uint64_t bytes_ = 0;
};

}  // namespace burnish
