#include "common/base/scratch_space.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <unistd.h>
#include <utility>

#include <sys/mman.h>

#include "common/base/scratch_file.h"

namespace burnish {

namespace {

/// An open file that nobody else can see. It lives as long as somebody has it open or mapped.
class NamelessFile {
 public:
  explicit NamelessFile(const std::filesystem::path& folder) : file_(open_nameless(folder)) {}
  ~NamelessFile() {
    if (file_ >= 0) ::close(file_);
  }

  /// Returns null and sets errno if the disk has no room. Room taken now cannot fail later, when a
  /// write through the mapping would end the process.
  void* map(uint64_t bytes) const {
    if (file_ < 0) return nullptr;
    const int error = posix_fallocate(file_, 0, static_cast<off_t>(bytes));
    errno = error;
    if (error != 0) return nullptr;
    void* data = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, file_, 0);
    return data == MAP_FAILED ? nullptr : data;
  }

 private:
  int file_;
};

// Not from the heap, which would keep freed blocks.
void* map_memory(uint64_t bytes) {
  void* data = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (data == MAP_FAILED) throw std::bad_alloc();
  return data;
}

void* map_file(const std::filesystem::path& folder, uint64_t bytes) {
  void* data = NamelessFile(folder).map(bytes);
  if (data == nullptr)
    throw ScratchFull("a scratch file of " + std::to_string(bytes) + " bytes in " +
                      folder.string() + ": " + std::strerror(errno));
  return data;
}

}  // namespace

ScratchBlock::ScratchBlock(ScratchBlock&& other) noexcept {
  *this = std::move(other);
}

ScratchBlock& ScratchBlock::operator=(ScratchBlock&& other) noexcept {
  std::swap(data_, other.data_);
  std::swap(bytes_, other.bytes_);
  count_.swap(other.count_);
  return *this;
}

ScratchBlock::~ScratchBlock() {
  if (data_ == nullptr) return;
  munmap(data_, bytes_);
  *count_ -= bytes_;
}

bool ScratchSpace::take_memory(uint64_t bytes) const {
  if (folder_.empty()) {
    *memory_ += bytes;
    return true;
  }
  uint64_t taken = memory_->load();
  do {
    if (taken > memory_bytes_max_ || bytes > memory_bytes_max_ - taken) return false;
  } while (!memory_->compare_exchange_weak(taken, taken + bytes));
  return true;
}

ScratchBlock ScratchSpace::allocate(uint64_t bytes) const {
  ScratchBlock block;
  if (bytes == 0) return block;
  const bool is_in_memory = take_memory(bytes);
  const auto& count = is_in_memory ? memory_ : files_;
  if (!is_in_memory) *files_ += bytes;
  try {
    block.data_ = is_in_memory ? map_memory(bytes) : map_file(folder_, bytes);
  } catch (...) {
    *count -= bytes;
    throw;
  }
  block.bytes_ = bytes;
  block.count_ = count;
  return block;
}

}  // namespace burnish
