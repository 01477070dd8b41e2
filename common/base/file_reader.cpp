#include "common/base/file_reader.h"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <fcntl.h>
#include <string>
#include <unistd.h>
#include <utility>

#include <sys/stat.h>

namespace burnish {

Result<FileReader> FileReader::open(const std::filesystem::path& path) {
  // Without O_NONBLOCK open() would wait at a pipe that nobody writes to.
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (file < 0) return errno_status("cannot open " + path.string(), errno);
  FileReader reader(file, path);
  struct stat status;
  if (fstat(file, &status) != 0) return errno_status("cannot examine " + path.string(), errno);
  if (!S_ISREG(status.st_mode))
    return invalid_argument("cannot read " + path.string() + ": it is not a regular file");
  reader.file_bytes_ = static_cast<uint64_t>(status.st_size);
  return reader;
}

FileReader::FileReader(FileReader&& other) noexcept
    : file_(std::exchange(other.file_, -1)),
      path_(std::move(other.path_)),
      file_bytes_(other.file_bytes_) {}

FileReader& FileReader::operator=(FileReader&& other) noexcept {
  std::swap(file_, other.file_);
  path_.swap(other.path_);
  file_bytes_ = other.file_bytes_;
  return *this;
}

FileReader::~FileReader() {
  if (file_ >= 0) ::close(file_);
}

Status FileReader::read(uint64_t offset, std::span<uint8_t> bytes) const {
  size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t got =
        ::pread(file_, bytes.data() + done, bytes.size() - done, static_cast<off_t>(offset + done));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return errno_status("cannot read " + path_.string(), errno);
    if (got == 0)
      return data_loss(path_.string() + " ended after " + std::to_string(offset + done) + " of " +
                       std::to_string(offset + bytes.size()) + " bytes");
    done += static_cast<size_t>(got);
  }
  return Status::ok();
}

Status FileReader::read_together(uint64_t offset, std::span<uint8_t> bytes,
                                 const std::function<bool()>& goes_on) const {
  constexpr size_t kPiece = size_t{1} << 20;
  const size_t pieces = (bytes.size() + kPiece - 1) / kPiece;
  std::atomic<bool> is_cancelled = false, has_failed = false;
#pragma omp parallel for schedule(dynamic) if (pieces > 1)
  for (size_t i = 0; i < pieces; ++i) {
    if (is_cancelled || has_failed) continue;
    const size_t begin = i * kPiece;
    if (goes_on && !goes_on())
      is_cancelled = true;
    else if (!read(offset + begin, bytes.subspan(begin, std::min(kPiece, bytes.size() - begin)))
                  .is_ok())
      has_failed = true;
  }
  if (is_cancelled) return cancelled("reading " + path_.string() + " was cancelled");
  if (has_failed) return read(offset, bytes);  // it says why, of all bytes
  return Status::ok();
}

Result<std::vector<uint8_t>> FileReader::read(uint64_t offset, size_t size) const {
  std::vector<uint8_t> bytes(size);
  RETURN_IF_ERROR(read(offset, bytes));
  return bytes;
}

}  // namespace burnish
