#include "server/lease/leased_file.h"

#include <cerrno>
#include <fcntl.h>
#include <string>
#include <unistd.h>
#include <utility>

#include <sys/mman.h>
#include <sys/stat.h>

#include "server/lease/lease_watch.h"

namespace burnish {

namespace {

Result<size_t> length_of(int file, const std::filesystem::path& path) {
  struct stat status;
  if (fstat(file, &status) != 0) return errno_status("cannot examine " + path.string(), errno);
  return static_cast<size_t>(status.st_size);
}

Status map(FileLease& lease, const std::filesystem::path& path) {
  ASSIGN_OR_RETURN(lease.size, length_of(lease.file, path));
  if (lease.size == 0) return failed_precondition(path.string() + " is empty");
  void* data = mmap(nullptr, lease.size, PROT_READ, MAP_SHARED, lease.file, 0);
  if (data == MAP_FAILED) return errno_status("cannot map " + path.string(), errno);
  lease.data = data;
  return Status::ok();
}

}  // namespace

Result<LeasedFile> LeasedFile::open(const std::filesystem::path& path,
                                    std::filesystem::path folder) {
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (file < 0) return errno_status("cannot open " + path.string(), errno);
  LeasedFile leased(std::make_unique<FileLease>(file, std::move(folder)));
  FileLease& lease = *leased.lease_;
  RETURN_IF_ERROR(map(lease, path));
  RETURN_IF_ERROR(LeaseWatch::instance().take(lease).with_context(path.string()));
  ASSIGN_OR_RETURN(const size_t now, length_of(file, path));
  if (now != lease.size) return failed_precondition(path.string() + " changes while it is opened");
  return leased;
}

LeasedFile::LeasedFile(std::unique_ptr<FileLease> lease) : lease_(std::move(lease)) {}
LeasedFile::LeasedFile(LeasedFile&& other) noexcept = default;

LeasedFile& LeasedFile::operator=(LeasedFile&& other) noexcept {
  lease_.swap(other.lease_);
  return *this;
}

LeasedFile::~LeasedFile() {
  if (!lease_) return;
  LeaseWatch::instance().give_back(*lease_);
  if (lease_->data != nullptr) munmap(lease_->data, lease_->size);
  ::close(lease_->file);
}

std::span<const uint8_t> LeasedFile::bytes() const {
  return {static_cast<const uint8_t*>(lease_->data), lease_->size};
}

}  // namespace burnish
