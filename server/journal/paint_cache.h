#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "server/journal/group_commit.h"
#include "server/journal/paint_rows.h"

namespace burnish {

/// Paint in a file of the server's own, for a journal that is elsewhere. A server that has none
/// replays the strokes. Thread-safe.
class PaintCache {
 public:
  /// Begins anew if the file is damaged. Fails: as SQLite says.
  static Result<std::unique_ptr<PaintCache>> open(const std::filesystem::path& path);

  void keep(const std::string& session_id, const PaintCheckpoint& paint) {
    keep_paint_row(commit_, session_id, paint);
  }
  Result<std::vector<PaintCheckpoint>> read(const std::string& session_id, size_t cell_count) {
    return read_paint_rows(commit_, session_id, cell_count);
  }

  /// Keeps the paint of a session for another one too.
  void copy(const std::string& from, const std::string& to);
  void forget(const std::string& session_id);

 private:
  explicit PaintCache(Database database) : commit_(std::move(database)) {}

  GroupCommit commit_;
};

}  // namespace burnish
