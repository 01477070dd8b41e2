#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <variant>

#include "common/base/mapped_file.h"
#include "server/lease/leased_file.h"

namespace burnish {

/// A file's bytes while they are read: under a lease where there are leases, with copies in the
/// file's own folder; else mapped as they are, so that who shortens the file ends the process.
class HeldFile {
 public:
  /// Fails: as MappedFile::open().
  static Result<HeldFile> open(const std::filesystem::path& path);

  /// Empty for an empty file.
  std::span<const uint8_t> bytes() const;
  bool is_leased() const { return std::holds_alternative<LeasedFile>(file_); }

 private:
  using File = std::variant<LeasedFile, MappedFile>;
  explicit HeldFile(File file) : file_(std::move(file)) {}

  File file_;
};

}  // namespace burnish
