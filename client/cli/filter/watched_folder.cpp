#include "client/cli/filter/watched_folder.h"

#include <cerrno>
#include <poll.h>
#include <unistd.h>

#include <sys/inotify.h>
#include <sys/stat.h>

#include "common/mesh/mesh_format.h"

namespace burnish {

namespace fs = std::filesystem;

static Status failed_at(const fs::path& folder, int error) {
  return errno_status("cannot watch the folder " + folder.string(), error);
}

Result<std::unique_ptr<WatchedFolder>> WatchedFolder::open(const fs::path& folder) {
  const int events = ::inotify_init1(IN_NONBLOCK | IN_CLOEXEC);
  if (events < 0) return failed_at(folder, errno);
  std::unique_ptr<WatchedFolder> watched(new WatchedFolder(folder, events));
  const uint32_t kinds = IN_CLOSE_WRITE | IN_MOVED_TO | IN_ONLYDIR;
  if (::inotify_add_watch(events, folder.c_str(), kinds) < 0) return failed_at(folder, errno);
  return watched;
}

WatchedFolder::~WatchedFolder() {
  ::close(events_);
}

static bool is_mesh_file(const fs::path& path) {
  return path.filename().string()[0] != '.' && mesh_format_of_path(path).is_ok();
}

/// Returns the files as they lie there. Fails: as errno says.
static Result<std::vector<WatchedFile>> files_in(const fs::path& folder) {
  std::vector<WatchedFile> files;
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    struct stat facts;
    if (!is_mesh_file(at->path()) || ::stat(at->path().c_str(), &facts) != 0) continue;
    if (!S_ISREG(facts.st_mode)) continue;
    const int64_t written_ns =
        int64_t{facts.st_mtim.tv_sec} * 1'000'000'000 + facts.st_mtim.tv_nsec;
    files.push_back({at->path(), static_cast<uint64_t>(facts.st_size), written_ns, facts.st_ino});
  }
  if (error) return failed_at(folder, error.value());
  return files;
}

Result<std::vector<WatchedFile>> WatchedFolder::still_files(std::chrono::milliseconds still) {
  ASSIGN_OR_RETURN(const std::vector<WatchedFile> files, files_in(folder_));
  const Clock::time_point now = Clock::now();
  std::map<fs::path, Seen> seen;
  for (const WatchedFile& file : files) {
    const auto before = seen_.find(file.path);
    const bool is_same = before != seen_.end() && before->second.file == file;
    seen[file.path] = {file, is_same ? before->second.since : now};
  }
  seen_ = std::move(seen);
  std::vector<WatchedFile> result;
  for (const auto& [path, of] : seen_)
    if (now - of.since >= still) result.push_back(of.file);
  has_moving_ = result.size() < seen_.size();
  return result;
}

void WatchedFolder::wait(std::chrono::milliseconds time) const {
  pollfd wanted = {events_, POLLIN, 0};
  if (::poll(&wanted, 1, static_cast<int>(time.count())) <= 0) return;
  char events[4096];
  while (::read(events_, events, sizeof events) > 0) {
  }
}

}  // namespace burnish
