#include "server/session/upload.h"

#include <cerrno>

#include <fcntl.h>
#include <unistd.h>

#include "common/service/chunk.h"
#include "server/session/synced_files.h"

namespace burnish {

Result<std::unique_ptr<Upload>> Upload::create(const std::filesystem::path& path,
                                               uint64_t size_bytes) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0644);
  if (file < 0) return errno_status("cannot create " + path.string(), errno);
  return std::unique_ptr<Upload>(new Upload(path, file, size_bytes));
}

Upload::~Upload() {
  ::close(file_);
  ::unlink(path_.c_str());
}

Status Upload::append(uint64_t offset, std::string_view data, uint32_t crc32) {
  RETURN_IF_ERROR(check_chunk(received_bytes_, offset, data, crc32));
  if (data.size() > size_bytes_ - received_bytes_)
    return invalid_argument("the file was announced with " + std::to_string(size_bytes_) +
                            " bytes and has more");
  RETURN_IF_ERROR(write_all(file_, data, "cannot store the upload"));
  hash_.update(data);
  received_bytes_ += data.size();
  return Status::ok();
}

Result<std::string> Upload::finish() {
  if (received_bytes_ != size_bytes_)
    return data_loss("the upload ended after " + std::to_string(received_bytes_) + " of " +
                     std::to_string(size_bytes_) + " bytes");
  if (::fsync(file_) != 0) return errno_status("cannot store the upload", errno);
  return hash_.finish();
}

}  // namespace burnish
