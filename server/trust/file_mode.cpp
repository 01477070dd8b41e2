#include "server/trust/file_mode.h"

#include <cstdio>

namespace burnish {

Status refuse_mode(const std::filesystem::path& path, mode_t bits, const char* what) {
  struct stat found = {};
  if (stat(path.c_str(), &found) != 0 || (found.st_mode & bits) == 0) return Status::ok();
  char mode[8];
  std::snprintf(mode, sizeof(mode), "%04o", static_cast<unsigned>(found.st_mode & 07777u));
  return failed_precondition(path.string() + " can be " + what + " by everybody: its mode is " +
                             mode + "; run chmod o= on it");
}

}  // namespace burnish
