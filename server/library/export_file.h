#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "common/base/progress.h"
#include "common/base/status.h"
#include "common/service/session_info.h"
#include "server/metrics/live_objects.h"

namespace burnish {

/// An exported mesh on its way to a client: a staging file without a name, gone with this object.
class ExportFile {
 public:
  /// Takes over the file at `path`: reads it once for its size and hash, and unlinks it. Fails:
  /// cancelled; as errno says.
  static Result<std::unique_ptr<ExportFile>> adopt(const std::filesystem::path& path,
                                                   ExportSummary summary, const Progress& progress);
  ~ExportFile();

  const ExportSummary& summary() const { return summary_; }

  /// Returns up to kChunkBytes from `offset` on; empty at the end.
  Result<std::string> read(uint64_t offset) const;

 private:
  ExportFile(int file, ExportSummary summary) : file_(file), summary_(std::move(summary)) {}

  int file_;
  ExportSummary summary_;
  LiveObject live_{LiveKind::kExport};
};

}  // namespace burnish
