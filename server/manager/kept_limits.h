#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "common/base/status.h"
#include "server/manager/caller.h"
#include "server/manager/kept_shares.h"

namespace burnish {

/// Bounds of what the server keeps. Those of a user hold for callers with Caller::has_share().
struct KeptLimits {
  size_t sessions_max = 64;
  uint64_t sessions_per_user = 1'000'000;  ///< that a user made, in memory or not
  size_t sessions_for_owners = 0;          ///< the last places; at most half of sessions_max count
  uint64_t history_bytes_per_session = UINT64_MAX;
  uint64_t history_bytes_per_user = UINT64_MAX;  ///< of the sessions that a user made
};

/// Checks whether the caller may have another session when the server keeps `sessions`. Fails:
/// resource_exhausted with the numbers and the setting.
Status check_session_room(const KeptLimits& limits, size_t sessions, const KeptShares& shares,
                          const Caller& caller);

/// The growth of one session's history.
struct HistoryGrowth {
  std::string maker;        ///< of the session
  uint64_t has = 0;         ///< bytes of the session
  uint64_t more = 0;        ///< bytes
  bool takes_back = false;  ///< undo, redo, switch, restore: these have kHistoryReserveBytes beyond
};

/// Checks whether a session's history may grow by the caller's edits. Fails: resource_exhausted
/// with the numbers and the setting.
Status check_history_room(const KeptLimits& limits, const HistoryGrowth& growth,
                          const KeptShares& shares, const Caller& caller);

}  // namespace burnish
