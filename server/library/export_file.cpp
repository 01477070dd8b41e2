#include "server/library/export_file.h"

#include <cerrno>
#include <fcntl.h>
#include <unistd.h>

#include "common/base/loop_progress.h"
#include "common/transfer/chunk.h"
#include "common/transfer/content_hash.h"

namespace burnish {

Result<std::unique_ptr<ExportFile>> ExportFile::adopt(const std::filesystem::path& path,
                                                      ExportSummary summary,
                                                      const Progress& progress) {
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return errno_status("cannot read " + path.string(), errno);
  ::unlink(path.c_str());
  std::unique_ptr<ExportFile> result(new ExportFile(file, std::move(summary)));
  ContentHash hash;
  uint64_t size_bytes = 0;
  for (LoopProgress loop(progress, "writing", 0, 0);;) {
    if (!loop.goes_on(0)) return cancelled("the export was cancelled");
    ASSIGN_OR_RETURN(const std::string piece, result->read(size_bytes));
    if (piece.empty()) break;
    hash.update(piece);
    size_bytes += piece.size();
  }
  result->summary_.size_bytes = size_bytes;
  result->summary_.sha256 = hash.finish();
  return result;
}

ExportFile::~ExportFile() {
  ::close(file_);
}

Result<std::string> ExportFile::read(uint64_t offset) const {
  std::string piece(kChunkBytes, '\0');
  const ssize_t got = ::pread(file_, piece.data(), piece.size(), static_cast<off_t>(offset));
  if (got < 0) return errno_status("cannot read the exported file", errno);
  piece.resize(static_cast<size_t>(got));
  return piece;
}

}  // namespace burnish
