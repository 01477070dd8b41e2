#include "common/base/mapped_file.h"

#include <cerrno>
#include <fcntl.h>
#include <unistd.h>
#include <utility>

#include <sys/mman.h>
#include <sys/stat.h>

namespace burnish {

static Result<size_t> size_to_map(int fd, const std::filesystem::path& path) {
  struct stat status;
  if (fstat(fd, &status) != 0) return errno_status("cannot examine " + path.string(), errno);
  if (S_ISDIR(status.st_mode))
    return invalid_argument("cannot read " + path.string() + ": it is a directory");
  if (!S_ISREG(status.st_mode))
    return invalid_argument("cannot read " + path.string() + ": it is not a regular file");
  return static_cast<size_t>(status.st_size);
}

Result<MappedFile> MappedFile::open(const std::filesystem::path& path) {
  // Without O_NONBLOCK open() would wait at a pipe that nobody writes to.
  const int fd = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (fd < 0) return errno_status("cannot open " + path.string(), errno);
  const Result<size_t> size = size_to_map(fd, path);
  void* data = nullptr;
  int map_error = 0;
  if (size.is_ok() && *size > 0) {
    data = mmap(nullptr, *size, PROT_READ, MAP_PRIVATE, fd, 0);
    if (data == MAP_FAILED) map_error = errno;
  }
  ::close(fd);  // the mapping lives on without it
  if (!size.is_ok()) return size.status();
  if (map_error != 0) return errno_status("cannot map " + path.string(), map_error);

  MappedFile file;
  file.data_ = static_cast<const uint8_t*>(data);
  file.size_ = *size;
  return file;
}

MappedFile::MappedFile(MappedFile&& other) noexcept {
  *this = std::move(other);
}

MappedFile& MappedFile::operator=(MappedFile&& other) noexcept {
  std::swap(data_, other.data_);
  std::swap(size_, other.size_);
  return *this;
}

MappedFile::~MappedFile() {
  if (data_ != nullptr) munmap(const_cast<uint8_t*>(data_), size_);
}

}  // namespace burnish
