#pragma once

#include <cstdint>
#include <filesystem>
#include <span>

#include "common/base/status.h"

namespace burnish {

/// Returns the user's folder for temporary files: TMPDIR, or the system's. Fails: as errno says, if
/// there is no such folder.
Result<std::filesystem::path> temporary_folder();

/// Opens a file of a folder that has no name, for reading and writing. The disk takes it back when
/// it is closed, however the process ends. Returns -1 and sets errno on failure.
int open_nameless(const std::filesystem::path& folder);

/// A file without a name, whose parts are copied to memory. Unlike ScratchSpace's mapped files it
/// never counts as memory of the process. Threads may use different parts at the same time.
class ScratchFile {
 public:
  /// Needs: the folder exists. Fails: as errno says.
  static Result<ScratchFile> create(const std::filesystem::path& folder);
  /// Makes one that lies in memory. Fails: as errno says.
  static Result<ScratchFile> create_in_memory();
  ScratchFile(ScratchFile&& other) noexcept;
  ScratchFile& operator=(ScratchFile&& other) noexcept;
  ~ScratchFile();

  /// Takes room for so many bytes in all; the new ones are zero. Fails: resource_exhausted.
  Status reserve(uint64_t bytes);

  /// Fails: resource_exhausted when the disk is full; as errno says.
  Status write(uint64_t offset, std::span<const uint8_t> bytes) const;

  /// Fails: data_loss (the file ends before); as errno says.
  Status read(uint64_t offset, std::span<uint8_t> bytes) const;

  /// Maps the first bytes for reading in the place of whatever is mapped at `address`. They stay
  /// mapped when this object ends. Fails: as errno says.
  Status map_over(void* address, uint64_t bytes) const;

 private:
  explicit ScratchFile(int file) : file_(file) {}

  int file_ = -1;
};

}  // namespace burnish
