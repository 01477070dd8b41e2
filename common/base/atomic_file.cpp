#include "common/base/atomic_file.h"

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <string>
#include <unistd.h>
#include <utility>

#include <sys/stat.h>

namespace burnish {

namespace fs = std::filesystem;

static Result<fs::path> writable_target(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (fs::is_directory(status))
    return invalid_argument("cannot write " + path.string() + ": it is a directory");
  if (fs::exists(status) && !fs::is_regular_file(status))
    return invalid_argument("cannot write " + path.string() + ": it is not a regular file");
  if (!fs::is_symlink(fs::symlink_status(path, error))) return path;
  const fs::path target = fs::weakly_canonical(path, error);
  if (error) return errno_status("cannot follow the link " + path.string(), error.value());
  return target;
}

static fs::path next_temporary_path(const fs::path& path) {
  static std::atomic<uint64_t> counter = 0;
  return path.string() + "." + std::to_string(getpid()) + "-" + std::to_string(counter++) + ".tmp";
}

Result<AtomicFile> AtomicFile::create(const fs::path& path, FileAccess access) {
  AtomicFile file;
  ASSIGN_OR_RETURN(file.path_, writable_target(path));
  const mode_t mode = access == FileAccess::kUserOnly ? 0600 : 0666;
  fs::path temporary;
  do {  // a killed process may have left a file of this name
    temporary = next_temporary_path(file.path_);
    file.fd_ = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
  } while (file.fd_ < 0 && errno == EEXIST);
  if (file.fd_ < 0) return errno_status("cannot write " + path.string(), errno);
  file.temporary_path_ = std::move(temporary);

  if (access == FileAccess::kUserOnly) return file;
  struct stat existing;
  if (stat(file.path_.c_str(), &existing) == 0 && fchmod(file.fd_, existing.st_mode & 07777) != 0)
    return errno_status("cannot copy the permissions of " + path.string(), errno);
  return file;
}

AtomicFile::AtomicFile(AtomicFile&& other) noexcept {
  *this = std::move(other);
}

AtomicFile& AtomicFile::operator=(AtomicFile&& other) noexcept {
  std::swap(path_, other.path_);
  std::swap(temporary_path_, other.temporary_path_);
  std::swap(fd_, other.fd_);
  return *this;
}

AtomicFile::~AtomicFile() {
  if (fd_ >= 0) ::close(fd_);
  if (!temporary_path_.empty()) ::unlink(temporary_path_.c_str());
}

Status AtomicFile::write(std::span<const uint8_t> bytes) {
  BURNISH_CHECK(fd_ >= 0, "write to " + path_.string() + " after its commit");
  while (!bytes.empty()) {
    const ssize_t written = ::write(fd_, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return errno_status("cannot write " + path_.string(), errno);
    bytes = bytes.subspan(static_cast<size_t>(written));
  }
  return Status::ok();
}

Status AtomicFile::write(std::string_view text) {
  return write({reinterpret_cast<const uint8_t*>(text.data()), text.size()});
}

Status AtomicFile::sync_and_close() {
  const int sync_error = fsync(fd_) == 0 ? 0 : errno;
  const int close_error = ::close(std::exchange(fd_, -1)) == 0 ? 0 : errno;
  if (sync_error != 0) return errno_status("cannot sync " + path_.string(), sync_error);
  if (close_error != 0) return errno_status("cannot close " + path_.string(), close_error);
  return Status::ok();
}

Status check_writable(const fs::path& path) {
  return AtomicFile::create(path).status();
}

Status sync_folder(const fs::path& folder) {
  const int fd = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (fd < 0) return errno_status("cannot open " + folder.string(), errno);
  const int error = fsync(fd) == 0 ? 0 : errno;
  ::close(fd);
  return error == 0 ? Status::ok() : errno_status("cannot sync " + folder.string(), error);
}

Status AtomicFile::commit() {
  BURNISH_CHECK(fd_ >= 0, "second commit of " + path_.string());
  RETURN_IF_ERROR(sync_and_close());
  if (std::rename(temporary_path_.c_str(), path_.c_str()) != 0)
    return errno_status("cannot rename " + temporary_path_.string() + " to " + path_.string(),
                        errno);
  temporary_path_.clear();
  const fs::path folder = path_.parent_path();
  return sync_folder(folder.empty() ? fs::path(".") : folder);
}

Status write_file(const std::filesystem::path& path, std::string_view text, FileAccess access) {
  ASSIGN_OR_RETURN(AtomicFile file, AtomicFile::create(path, access));
  RETURN_IF_ERROR(file.write(text));
  return file.commit();
}

}  // namespace burnish
