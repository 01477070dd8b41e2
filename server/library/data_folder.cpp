#include "server/library/data_folder.h"

#include <array>
#include <cerrno>
#include <fcntl.h>
#include <random>
#include <span>
#include <unistd.h>

#include <sys/file.h>
#include <sys/stat.h>

#include "common/base/text.h"

namespace burnish {

namespace fs = std::filesystem;

// Enough for a journal to open and to delete with, eight times: other programs may fill the disk
// again between two starts.
static constexpr uint64_t kSpareBytes = 4 << 20;
static constexpr uint64_t kSpareSlice = kSpareBytes / 8;

// Only the owner may read scans and edits, whatever the umask. An existing folder keeps its mode.
static Status make_folder(const fs::path& path) {
  const fs::path folder = path.has_filename() ? path : path.parent_path();
  std::error_code error;
  if (folder.has_parent_path()) fs::create_directories(folder.parent_path(), error);
  if (error)
    return errno_status("cannot make the folder " + folder.parent_path().string(), error.value());
  if (::mkdir(folder.c_str(), 0700) == 0) return Status::ok();
  const int failure = errno;
  if (failure == EEXIST && fs::is_directory(folder, error)) return Status::ok();
  return errno_status("cannot make the folder " + folder.string(), failure);
}

static Result<int> take_lock(const fs::path& folder) {
  const fs::path path = folder / "lock";
  const int file = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
  // A user who can open it can lock it and keep the server from starting; older versions made it
  // 0644.
  if (file >= 0) (void)::fchmod(file, 0600);
  if (file < 0) return errno_status("cannot open " + path.string(), errno);
  if (::flock(file, LOCK_EX | LOCK_NB) == 0) return file;
  const int error = errno;
  ::close(file);
  if (error == EWOULDBLOCK)
    return failed_precondition("another burnish-server uses the data folder " + folder.string());
  return errno_status("cannot lock " + path.string(), error);
}

static Status empty_staging(const fs::path& staging) {
  std::error_code error;
  fs::remove_all(staging, error);
  if (error) return errno_status("cannot empty the folder " + staging.string(), error.value());
  return make_folder(staging);
}

Result<std::unique_ptr<DataFolder>> DataFolder::open(const fs::path& path) {
  RETURN_IF_ERROR(make_folder(path));
  ASSIGN_OR_RETURN(const int lock, take_lock(path));
  std::unique_ptr<DataFolder> folder(new DataFolder(path, lock));
  RETURN_IF_ERROR(make_folder(folder->scans()));
  RETURN_IF_ERROR(empty_staging(path / "staging"));
  return folder;
}

DataFolder::~DataFolder() {
  ::close(lock_);
}

uint64_t DataFolder::free_bytes() const {
  std::error_code error;
  const fs::space_info space = fs::space(path_, error);
  return error ? 0 : space.available;
}

void DataFolder::keep_spare() const {
  static constexpr uint64_t kPlentyBytes = 64 << 20;
  std::error_code error;
  if (fs::file_size(spare(), error) == kSpareBytes || free_bytes() < kPlentyBytes) return;
  const int file = ::open(spare().c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600);
  if (file < 0) return;
  if (::posix_fallocate(file, 0, kSpareBytes) != 0) fs::remove(spare(), error);
  ::close(file);
}

bool DataFolder::has_room_to_start() const {
  return free_bytes() >= kSpareSlice;
}

bool DataFolder::give_spare() const {
  std::error_code error;
  const uint64_t size = fs::file_size(spare(), error);
  if (error || size < kSpareSlice) return false;
  fs::resize_file(spare(), size - kSpareSlice, error);
  return !error;
}

fs::path DataFolder::staging_path(const std::string& suffix) const {
  return path_ / "staging" / (random_name() + suffix);
}

std::string random_name() {
  std::random_device device;
  const std::array<uint32_t, 2> bits = {device(), device()};
  return to_hex(std::as_bytes(std::span(bits)));
}

}  // namespace burnish
