#pragma once

#include "server/manager/session_entry.h"
#include "server/manager/session_manager.h"

namespace burnish {

struct SessionManager::Held {
  std::shared_ptr<SessionEntry> entry;
  std::unique_lock<FairMutex> lock;
};

}  // namespace burnish
