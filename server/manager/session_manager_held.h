#pragma once

#include "server/manager/session_entry.h"
#include "server/manager/session_manager.h"

namespace burnish {

struct SessionManager::Held {
  std::shared_ptr<SessionEntry> entry;
  std::unique_lock<FairMutex> lock;
};

/// Reads a session of the journal that is not in memory.
Result<std::shared_ptr<SessionEntry>> read_entry(Journal& journal, const SessionRecord& record);

}  // namespace burnish
