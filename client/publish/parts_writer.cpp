#include "client/publish/parts_writer.h"

#include <bit>
#include <utility>

namespace burnish {

namespace fs = std::filesystem;

static_assert(std::endian::native == std::endian::little, "the index is written as it lies");

static constexpr const char* kUnnamed = "parts";
static constexpr size_t kHashDigits = 16;

PartsWriter::PartsWriter(fs::path folder, AtomicFile file)
    : folder_(std::move(folder)), file_(std::move(file)) {}

Result<PartsWriter> PartsWriter::create(const fs::path& folder) {
  ASSIGN_OR_RETURN(AtomicFile file, AtomicFile::create(folder / kUnnamed));
  return PartsWriter(folder, std::move(file));
}

Status PartsWriter::add(std::string_view part) {
  RETURN_IF_ERROR(file_.write(part));
  hash_.update(part);
  lengths_.push_back(static_cast<uint32_t>(part.size()));
  bytes_ += part.size();
  return Status::ok();
}

Result<PartsFiles> PartsWriter::finish() {
  const std::string_view index(reinterpret_cast<const char*>(lengths_.data()),
                               lengths_.size() * sizeof(uint32_t));
  hash_.update(index);
  const std::string stem = "scan-" + hash_.finish().substr(0, kHashDigits);
  const PartsFiles files{stem + ".parts", stem + ".index"};
  RETURN_IF_ERROR(file_.commit());
  std::error_code error;
  fs::rename(folder_ / kUnnamed, folder_ / files.parts, error);
  if (error) return errno_status("cannot rename " + files.parts, error.value());
  RETURN_IF_ERROR(write_file(folder_ / files.index, index));
  return files;
}

}  // namespace burnish
