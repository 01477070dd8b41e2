#include <cerrno>
#include <fstream>
#include <memory>

#include "client/model/documents/recorder.h"

namespace burnish {

Status Recorder::open(const std::filesystem::path& path) {
  const auto file = std::make_shared<std::ofstream>(path);
  if (!*file) return errno_status("cannot record to " + path.string(), errno);
  open([file](const std::string& line) { *file << line << std::endl; });  // a crash loses nothing
  return Status::ok();
}

}  // namespace burnish
