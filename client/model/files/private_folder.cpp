#include "client/model/files/private_folder.h"

#include <cerrno>
#include <cstdio>
#include <unistd.h>

#include <sys/stat.h>

namespace burnish {

static constexpr mode_t kUserMayAll = 0700;
static constexpr mode_t kOthersMayWrite = 0022, kOthersMayAnything = 0077;

static Status refused(const std::filesystem::path& path, const std::string& why) {
  return {StatusCode::kPermissionDenied, "the folder " + path.string() + " " + why};
}

static std::string octal(mode_t mode) {
  char text[8];
  std::snprintf(text, sizeof text, "%04o", static_cast<unsigned>(mode & 07777));
  return text;
}

Status make_private_folder(const std::filesystem::path& folder) {
  auto path = std::filesystem::absolute(folder).lexically_normal();
  if (!path.has_filename()) path = path.parent_path();  // "link/" means the target of link
  std::error_code error;
  std::filesystem::create_directories(path.parent_path(), error);
  if (error) return errno_status("cannot make " + path.parent_path().string(), error.value());
  if (mkdir(path.c_str(), kUserMayAll) != 0 && errno != EEXIST)
    return errno_status("cannot make " + path.string(), errno);
  struct stat found = {};
  if (lstat(path.c_str(), &found) != 0)
    return errno_status("cannot look at " + path.string(), errno);
  if (S_ISLNK(found.st_mode)) return refused(path, "is a link; name the folder that it points to");
  if (!S_ISDIR(found.st_mode)) return refused(path, "is a file");
  if (found.st_uid != geteuid())
    return refused(path, "belongs to user " + std::to_string(found.st_uid) + ", not to " +
                             std::to_string(geteuid()));
  if (found.st_mode & kOthersMayWrite)
    return refused(path, "has mode " + octal(found.st_mode) +
                             ": others may have written into it. Check its content, then run "
                             "chmod 700");
  if ((found.st_mode & kOthersMayAnything) && chmod(path.c_str(), kUserMayAll) != 0)
    return errno_status("cannot close " + path.string() + " to others", errno);
  return Status::ok();
}

}  // namespace burnish
