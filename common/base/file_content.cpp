#include "common/base/file_content.h"

#include <algorithm>
#include <new>
#include <string>

#include "common/base/file_reader.h"

namespace burnish {

static Result<ScratchBlock> make_room(const ScratchSpace& space, size_t size,
                                      const std::filesystem::path& path) {
  try {
    return space.allocate(size);
  } catch (const ScratchFull& full) {
    return resource_exhausted("reading " + path.string() + ": " + full.what());
  } catch (const std::bad_alloc&) {
    return resource_exhausted("not enough memory for the " + std::to_string(size) + " bytes of " +
                              path.string());
  }
}

Result<FileContent> FileContent::read(const std::filesystem::path& path,
                                      const ScratchSpace& space) {
  return read(path, SIZE_MAX, space);
}

Result<FileContent> FileContent::read_beginning(const std::filesystem::path& path,
                                                size_t bytes_max) {
  return read(path, bytes_max, {});
}

Result<FileContent> FileContent::read(const std::filesystem::path& path, size_t bytes_max,
                                      const ScratchSpace& space) {
  ASSIGN_OR_RETURN(const FileReader file, FileReader::open(path));
  FileContent content;
  content.size_ = std::min<size_t>(file.file_bytes(), bytes_max);
  content.file_bytes_ = file.file_bytes();
  ASSIGN_OR_RETURN(content.block_, make_room(space, content.size_, path));
  RETURN_IF_ERROR(
      file.read_together(0, {static_cast<uint8_t*>(content.block_.data()), content.size_}));
  return content;
}

}  // namespace burnish
