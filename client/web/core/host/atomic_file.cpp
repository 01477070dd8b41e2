// common/base/atomic_file.h where a file is a download of the user's.

#include "common/base/atomic_file.h"

#include <utility>

#include "client/web/core/host/imports.h"

namespace burnish {

static constexpr int kNone = -1;

Result<AtomicFile> AtomicFile::create(const std::filesystem::path& path, FileAccess) {
  AtomicFile file;
  file.path_ = path;
  const std::string name = path.filename().string();
  file.fd_ = host_download_begin(name.data(), name.size());
  return file;
}

AtomicFile::AtomicFile(AtomicFile&& other) noexcept
    : path_(std::move(other.path_)), fd_(std::exchange(other.fd_, kNone)) {}

AtomicFile& AtomicFile::operator=(AtomicFile&& other) noexcept {
  std::swap(path_, other.path_);
  std::swap(fd_, other.fd_);
  return *this;
}

AtomicFile::~AtomicFile() {
  if (fd_ != kNone) host_download_end(fd_, 0);
}

Status AtomicFile::write(std::span<const uint8_t> bytes) {
  host_download_add(fd_, bytes.data(), bytes.size());
  return Status::ok();
}

Status AtomicFile::write(std::string_view text) {
  return write({reinterpret_cast<const uint8_t*>(text.data()), text.size()});
}

Status AtomicFile::commit() {
  host_download_end(std::exchange(fd_, kNone), 1);
  return Status::ok();
}

Status write_file(const std::filesystem::path& path, std::string_view text, FileAccess access) {
  ASSIGN_OR_RETURN(AtomicFile file, AtomicFile::create(path, access));
  RETURN_IF_ERROR(file.write(text));
  return file.commit();
}

}  // namespace burnish
