#include "server/session/synced_files.h"

#include <cerrno>

#include <fcntl.h>
#include <unistd.h>

namespace burnish {

namespace fs = std::filesystem;

Status write_all(int file, std::string_view bytes, const std::string& what) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(file, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return errno_status(what, errno);
    bytes.remove_prefix(static_cast<size_t>(written));
  }
  return Status::ok();
}

static Status sync_open_file(int file, const std::string& what) {
  return ::fsync(file) == 0 ? Status::ok() : errno_status(what, errno);
}

Status write_synced(const fs::path& path, std::string_view bytes) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (file < 0) return errno_status("cannot create " + path.string(), errno);
  Status status = write_all(file, bytes, "cannot write " + path.string());
  if (status.is_ok()) status = sync_open_file(file, "cannot sync " + path.string());
  ::close(file);
  return status;
}

Status sync_folder(const fs::path& folder) {
  const int file = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (file < 0) return errno_status("cannot open " + folder.string(), errno);
  const Status status = sync_open_file(file, "cannot sync " + folder.string());
  ::close(file);
  return status;
}

}  // namespace burnish
