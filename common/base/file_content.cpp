#include "common/base/file_content.h"

#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <new>
#include <string>
#include <unistd.h>

#include <sys/stat.h>

namespace burnish {

static constexpr std::align_val_t kAlignment{64};

namespace {

/// A descriptor that is closed with this object.
class OpenFile {
 public:
  // Without O_NONBLOCK open() would wait at a pipe that nobody writes to.
  explicit OpenFile(const std::filesystem::path& path)
      : file_(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)) {}
  ~OpenFile() {
    if (file_ >= 0) ::close(file_);
  }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  int get() const { return file_; }

 private:
  int file_;
};

Result<uint64_t> size_of_regular_file(int file, const std::filesystem::path& path) {
  struct stat status;
  if (fstat(file, &status) != 0) return errno_status("cannot examine " + path.string(), errno);
  if (!S_ISREG(status.st_mode))
    return invalid_argument("cannot read " + path.string() + ": it is not a regular file");
  return static_cast<uint64_t>(status.st_size);
}

Status fill(int file, std::span<uint8_t> bytes, const std::filesystem::path& path) {
  size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t got =
        ::pread(file, bytes.data() + done, bytes.size() - done, static_cast<off_t>(done));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return errno_status("cannot read " + path.string(), errno);
    if (got == 0)
      return data_loss(path.string() + " ended after " + std::to_string(done) + " of " +
                       std::to_string(bytes.size()) + " bytes");
    done += static_cast<size_t>(got);
  }
  return Status::ok();
}

}  // namespace

void FileContent::Free::operator()(uint8_t* data) const {
  ::operator delete(data, kAlignment);
}

Result<FileContent> FileContent::allocate(size_t size, const std::filesystem::path& path) {
  FileContent content;
  content.size_ = size;
  if (size == 0) return content;
  content.data_.reset(static_cast<uint8_t*>(::operator new(size, kAlignment, std::nothrow)));
  if (content.data_) return content;
  return resource_exhausted("not enough memory for the " + std::to_string(size) + " bytes of " +
                            path.string());
}

Result<FileContent> FileContent::read(const std::filesystem::path& path) {
  return read_beginning(path, SIZE_MAX);
}

Result<FileContent> FileContent::read_beginning(const std::filesystem::path& path,
                                                size_t bytes_max) {
  const OpenFile file(path);
  if (file.get() < 0) return errno_status("cannot open " + path.string(), errno);
  ASSIGN_OR_RETURN(const uint64_t size, size_of_regular_file(file.get(), path));
  ASSIGN_OR_RETURN(FileContent content, allocate(std::min<size_t>(size, bytes_max), path));
  content.file_bytes_ = size;
  RETURN_IF_ERROR(fill(file.get(), {content.data_.get(), content.size_}, path));
  return content;
}

}  // namespace burnish
