#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <new>
#include <string>

namespace burnish {

/// Thrown when the disk has no room for a scratch file. It is caught before an interface.
class ScratchFull : public std::bad_alloc {
 public:
  explicit ScratchFull(std::string message) : message_(std::move(message)) {}
  const char* what() const noexcept override { return message_.c_str(); }

 private:
  std::string message_;
};

/// The bytes behind one large array. Movable; gives the bytes back at its end.
class ScratchBlock {
 public:
  ScratchBlock() = default;
  ScratchBlock(ScratchBlock&& other) noexcept;
  ScratchBlock& operator=(ScratchBlock&& other) noexcept;
  ~ScratchBlock();

  void* data() const { return data_; }

 private:
  friend class ScratchSpace;

  void* data_ = nullptr;
  uint64_t bytes_ = 0;
  std::shared_ptr<std::atomic<uint64_t>> count_;  ///< that these bytes are part of
};

/// Holds large arrays: in memory up to a limit, then in files of a folder. The files have no
/// names, so the disk takes them back when the process ends, however it ends. They are mapped: the
/// kernel writes their pages out and drops them when memory is short. A copy shares the limit.
/// Threads may use it at the same time.
class ScratchSpace {
 public:
  /// Puts everything into memory.
  ScratchSpace() = default;

  /// Needs: the folder exists.
  ScratchSpace(std::filesystem::path folder, uint64_t memory_bytes_max)
      : folder_(std::move(folder)), memory_bytes_max_(memory_bytes_max) {}

  /// The bytes are zero. Throws: std::bad_alloc; ScratchFull that names the folder and the bytes.
  ScratchBlock allocate(uint64_t bytes) const;

  uint64_t memory_bytes_max() const { return memory_bytes_max_; }
  uint64_t memory_bytes() const { return *memory_; }  ///< of arrays in memory now
  uint64_t file_bytes() const { return *files_; }     ///< of arrays in files now

 private:
  bool take_memory(uint64_t bytes) const;

  std::filesystem::path folder_;
  uint64_t memory_bytes_max_ = UINT64_MAX;
  std::shared_ptr<std::atomic<uint64_t>> memory_ = std::make_shared<std::atomic<uint64_t>>(0);
  std::shared_ptr<std::atomic<uint64_t>> files_ = std::make_shared<std::atomic<uint64_t>>(0);
};

}  // namespace burnish
