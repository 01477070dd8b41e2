#pragma once

#include "server/session/cancellable_lock.h"
#include "server/session/session_entry.h"
#include "server/session/session_manager.h"

namespace burnish {

struct SessionManager::Held {
  std::shared_ptr<SessionEntry> entry;
  std::unique_lock<FairMutex> lock;
};

}  // namespace burnish
