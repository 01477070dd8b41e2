#include "server/library/upload.h"

#include "common/transfer/chunk.h"

namespace burnish {

namespace fs = std::filesystem;

Result<std::unique_ptr<Upload>> Upload::create(const fs::path& path, uint64_t size_bytes,
                                               Quota::Share share) {
  ASSIGN_OR_RETURN(AtomicFile file, AtomicFile::create(path));
  return std::unique_ptr<Upload>(new Upload(path, std::move(file), size_bytes, std::move(share)));
}

Upload::~Upload() {
  std::error_code ignored;
  fs::remove(path_, ignored);
}

Status Upload::append(uint64_t offset, std::string_view data, uint32_t crc32) {
  RETURN_IF_ERROR(check_chunk(received_bytes_, offset, data, crc32));
  if (data.size() > size_bytes_ - received_bytes_)
    return invalid_argument("the file has more than the announced " + std::to_string(size_bytes_) +
                            " bytes");
  RETURN_IF_ERROR(file_.write(data).with_context("storing the upload"));
  hash_.update(data);
  received_bytes_ += data.size();
  return Status::ok();
}

Result<std::string> Upload::finish() {
  if (received_bytes_ != size_bytes_)
    return data_loss("the upload ended after " + std::to_string(received_bytes_) + " of " +
                     std::to_string(size_bytes_) + " bytes");
  RETURN_IF_ERROR(file_.commit().with_context("storing the upload"));
  return hash_.finish();
}

}  // namespace burnish
