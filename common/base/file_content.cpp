#include "common/base/file_content.h"

#include <algorithm>
#include <new>
#include <string>

#include "common/base/file_reader.h"

namespace burnish {

static constexpr std::align_val_t kAlignment{64};

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
  ASSIGN_OR_RETURN(const FileReader file, FileReader::open(path));
  ASSIGN_OR_RETURN(FileContent content,
                   allocate(std::min<size_t>(file.file_bytes(), bytes_max), path));
  content.file_bytes_ = file.file_bytes();
  RETURN_IF_ERROR(file.read(0, {content.data_.get(), content.size_}));
  return content;
}

}  // namespace burnish
