#include "server/lease/lease_watch.h"

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <fcntl.h>
#include <string>
#include <thread>
#include <unistd.h>

#include <sys/eventfd.h>
#include <sys/mman.h>

#include "common/base/scratch_file.h"

namespace burnish {

namespace {

std::atomic<int> wake_by_signal = -1;

void wake_watch(int) {
  const int error = errno;
  const uint64_t one = 1;
  (void)!::write(wake_by_signal, &one, sizeof(one));
  errno = error;
}

bool wants_back(const FileLease& lease) {
  return fcntl(lease.file, F_GETLEASE) != F_RDLCK;
}

Status put_copy(const FileLease& lease, Result<ScratchFile> made) {
  ASSIGN_OR_RETURN(ScratchFile copy, std::move(made));
  RETURN_IF_ERROR(copy.reserve(lease.size));
  RETURN_IF_ERROR(copy.write(0, {static_cast<const uint8_t*>(lease.data), lease.size}));
  return copy.map_over(lease.data, lease.size);
}

// Without any room the other goes on all the same, as the kernel would let him after a while.
void let_go(FileLease& lease) {
  if (!put_copy(lease, ScratchFile::create(lease.folder)).is_ok())
    (void)put_copy(lease, ScratchFile::create_in_memory());
  (void)fcntl(lease.file, F_SETLEASE, F_UNLCK);
}

}  // namespace

// Never ends: a signal may come while the process leaves.
LeaseWatch& LeaseWatch::instance() {
  static LeaseWatch* const watch = new LeaseWatch;
  return *watch;
}

LeaseWatch::LeaseWatch() : wake_(eventfd(0, EFD_CLOEXEC)) {
  if (wake_ < 0) return;
  wake_by_signal = wake_;
  struct sigaction action = {};
  action.sa_handler = wake_watch;
  action.sa_flags = SA_RESTART;
  sigaction(SIGIO, &action, nullptr);
  std::thread([this] { run(); }).detach();
}

Status LeaseWatch::take(FileLease& lease) {
  if (wake_ < 0) return failed_precondition("no lease: no eventfd was left");
  const std::lock_guard lock(mutex_);
  if (fcntl(lease.file, F_SETLEASE, F_RDLCK) != 0)
    return failed_precondition(std::string("no lease: ") + std::strerror(errno));
  leases_.push_back(&lease);
  return Status::ok();
}

void LeaseWatch::give_back(const FileLease& lease) {
  const std::lock_guard lock(mutex_);
  std::erase(leases_, &lease);
}

void LeaseWatch::run() {
  uint64_t count = 0;
  while (::read(wake_, &count, sizeof(count)) == sizeof(count) || errno == EINTR) {
    const std::lock_guard lock(mutex_);
    std::erase_if(leases_, [](FileLease* lease) {
      if (!wants_back(*lease)) return false;
      let_go(*lease);
      return true;
    });
  }
}

}  // namespace burnish
