#include "common/base/scratch_file.h"

#include <cerrno>
#include <cstdlib>
#include <fcntl.h>
#include <string>
#include <system_error>
#include <unistd.h>
#include <utility>

#include <sys/mman.h>

namespace burnish {

Result<std::filesystem::path> temporary_folder() {
  std::error_code error;
  std::filesystem::path folder = std::filesystem::temp_directory_path(error);
  if (!error) return folder;
  const char* const named = std::getenv("TMPDIR");
  return errno_status("the folder for temporary files" +
                          (named == nullptr ? std::string() : ", TMPDIR=" + std::string(named)),
                      error.value());
}

// Some file systems know no files without a name.
static int open_and_unlink(const std::filesystem::path& folder) {
  std::string name = (folder / ".scratch-XXXXXX").string();
  const int file = mkostemp(name.data(), O_CLOEXEC);
  if (file >= 0) ::unlink(name.c_str());
  return file;
}

int open_nameless(const std::filesystem::path& folder) {
  const int file = ::open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
  if (file < 0 && (errno == EOPNOTSUPP || errno == EISDIR)) return open_and_unlink(folder);
  return file;
}

Result<ScratchFile> ScratchFile::create(const std::filesystem::path& folder) {
  const int file = open_nameless(folder);
  if (file < 0) return errno_status("cannot open a scratch file in " + folder.string(), errno);
  return ScratchFile(file);
}

Result<ScratchFile> ScratchFile::create_in_memory() {
  const int file = memfd_create("burnish-scratch", MFD_CLOEXEC);
  if (file < 0) return errno_status("cannot open a scratch file in memory", errno);
  return ScratchFile(file);
}

ScratchFile::ScratchFile(ScratchFile&& other) noexcept : file_(std::exchange(other.file_, -1)) {}

ScratchFile& ScratchFile::operator=(ScratchFile&& other) noexcept {
  std::swap(file_, other.file_);
  return *this;
}

ScratchFile::~ScratchFile() {
  if (file_ >= 0) ::close(file_);
}

Status ScratchFile::reserve(uint64_t bytes) {
  const int error = posix_fallocate(file_, 0, static_cast<off_t>(bytes));
  if (error == 0) return Status::ok();
  return errno_status("a scratch file of " + std::to_string(bytes) + " bytes", error);
}

Status ScratchFile::write(uint64_t offset, std::span<const uint8_t> bytes) const {
  while (!bytes.empty()) {
    const ssize_t count = ::pwrite(file_, bytes.data(), bytes.size(), static_cast<off_t>(offset));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return errno_status("cannot write a scratch file", errno);
    offset += static_cast<uint64_t>(count);
    bytes = bytes.subspan(static_cast<size_t>(count));
  }
  return Status::ok();
}

Status ScratchFile::read(uint64_t offset, std::span<uint8_t> bytes) const {
  while (!bytes.empty()) {
    const ssize_t count = ::pread(file_, bytes.data(), bytes.size(), static_cast<off_t>(offset));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return errno_status("cannot read a scratch file", errno);
    if (count == 0)
      return data_loss("a scratch file ends " + std::to_string(bytes.size()) + " bytes early");
    offset += static_cast<uint64_t>(count);
    bytes = bytes.subspan(static_cast<size_t>(count));
  }
  return Status::ok();
}

Status ScratchFile::map_over(void* address, uint64_t bytes) const {
  if (mmap(address, bytes, PROT_READ, MAP_SHARED | MAP_FIXED, file_, 0) == MAP_FAILED)
    return errno_status("cannot map a scratch file of " + std::to_string(bytes) + " bytes", errno);
  return Status::ok();
}

}  // namespace burnish
