#include "server/journal/paint_rows.h"

#include <spdlog/spdlog.h>

#include "server/journal/sqlite_rows.h"

namespace burnish {

static Status insert_paint(Database& database, const std::string& session_id, int64_t series,
                           int64_t strokes, const std::string& bytes) {
  RETURN_IF_ERROR(run(database,
                      "INSERT OR REPLACE INTO paint (session_id, series, strokes, bytes)"
                      " VALUES (?, ?, ?, ?)",
                      session_id, series, strokes, bytes));
  return run(database,
             "DELETE FROM paint WHERE session_id = ?1 AND sequence NOT IN"
             " (SELECT sequence FROM paint WHERE session_id = ?1 ORDER BY sequence DESC LIMIT 8)",
             session_id);
}

void keep_paint_row(GroupCommit& commit, const std::string& session_id,
                    const PaintCheckpoint& paint) {
  commit.post_background(
      [session_id, series = static_cast<int64_t>(paint.series),
       strokes = static_cast<int64_t>(paint.strokes),
       bytes = painted_to_bytes(paint.painted)](Database& database) {
        return insert_paint(database, session_id, series, strokes, bytes);
      },
      [session_id](const WriteOutcome& outcome) {
        if (!outcome.is_on_disk())
          spdlog::warn("session {}: cannot keep its paint: {}", session_id,
                       outcome.status().message());
      });
}

Result<std::vector<PaintCheckpoint>> read_paint_rows(GroupCommit& commit,
                                                     const std::string& session_id,
                                                     size_t cell_count) {
  std::vector<PaintCheckpoint> kept;
  const auto take = [&](const Statement& row) {
    auto painted = painted_from_bytes(row.text(2), cell_count);
    if (painted.is_ok()) {
      kept.push_back({static_cast<uint64_t>(row.integer(0)), static_cast<uint64_t>(row.integer(1)),
                      std::move(*painted)});
    } else {
      spdlog::warn("session {}: {}", session_id, painted.status().message());
    }
    return Status::ok();
  };
  RETURN_IF_ERROR(commit.read([&](Database& database) {
    return read_rows(
        database, "SELECT series, strokes, bytes FROM paint WHERE session_id = ? ORDER BY sequence",
        take, session_id);
  }));
  return kept;
}

}  // namespace burnish
