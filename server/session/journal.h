#pragma once

#include <filesystem>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <vector>

#include "common/edit/edit.h"
#include "common/service/scan_info.h"
#include "server/session/sqlite.h"

namespace burnish {

/// What a session is, apart from its edits.
struct SessionRecord {
  std::string id;
  std::string name;
  std::string scan_id;
  PreparedKey key;
  int64_t created_unix_seconds = 0;
};

/// The sessions and their edits, on disk before anybody is told. It keeps intentions, never
/// solutions: applying a session's edits in order gives its state. Thread-safe.
class Journal {
 public:
  /// Fails: data_loss when the file is damaged or from a newer program; as SQLite says.
  static Result<std::unique_ptr<Journal>> open(const std::filesystem::path& path);

  /// By name.
  Result<std::vector<SessionRecord>> sessions();

  Status create_session(const SessionRecord& record);
  Status remove_session(const std::string& id);

  /// Appends all or none; returns when they are on disk. Needs: ids that the session has not seen.
  Status append(const std::string& session_id, std::span<const Edit> edits);

  /// In the order of their acknowledgement.
  Result<std::vector<Edit>> edits(const std::string& session_id);

  Result<uint64_t> edit_count(const std::string& session_id);

 private:
  explicit Journal(Database database) : database_(std::move(database)) {}

  std::mutex mutex_;
  Database database_;
};

}  // namespace burnish
