#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "common/base/record.h"
#include "common/edit/edit.h"
#include "common/service/session_info.h"

namespace burnish {

/// One line of a session's history.
struct HistoryEntry {
  uint64_t number = 0;  ///< counted over all edits of the session, undo and switches among them
  std::string edit_id;
  std::string author;
  int64_t unix_ms = 0;
  EditKind kind = EditKind::kGradientScale;  ///< makes fields, or kSetCheckpoint, kDamaged
  std::string summary;
  bool enabled = true;
  std::string name;     ///< see EditWords; empty from an older server
  std::string details;  ///< likewise
  double radius = 0;    ///< likewise
};
BURNISH_RECORD(HistoryEntry, number, edit_id, author, unix_ms, summary, enabled, name, details,
               radius)

inline constexpr uint32_t kHistoryPageEntriesMax = 1000;

/// Which part of a history: up to `count` entries from the first whose number is above `after`.
struct HistoryWish {
  std::string session;
  uint64_t after = 0;
  uint32_t count = kHistoryPageEntriesMax;
};
BURNISH_RECORD(HistoryWish, session, after, count)

struct HistoryPage {
  std::vector<HistoryEntry> entries;  ///< by number
  bool complete = true;               ///< no entry follows
};

/// A new session with the history of another up to a point.
struct ForkWish {
  std::string source;      ///< name or id
  std::string name;        ///< empty: the server chooses
  uint64_t number = 0;     ///< the last edit that the fork has; 0: all
  std::string checkpoint;  ///< not empty: all up to this checkpoint, and `number` is 0
  int depth = 0;           ///< 0: that of the source
};

struct ForkedSession {
  SessionInfo session;
  uint64_t emptied_edits = 0;  ///< set single cells, of which a fork at another depth has others
};

}  // namespace burnish
