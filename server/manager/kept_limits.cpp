#include "server/manager/kept_limits.h"

#include <algorithm>

#include "common/base/limits.h"
#include "server/metrics/metrics.h"

namespace burnish {

namespace {

Status refuse(Refusal reason, const std::string& message) {
  metrics().count_refusal(reason);
  return resource_exhausted(message);
}

Status no_place(const KeptLimits& limits, size_t sessions, size_t for_owners) {
  std::string message = "the server has " + std::to_string(sessions) +
                        " sessions; limits.sessions_max is " + std::to_string(limits.sessions_max);
  if (for_owners > 0)
    message += ", and its last " + std::to_string(for_owners) +
               " places are for owners of the server (limits.sessions_for_owners)";
  return refuse(Refusal::kKeptSessions, message + "; delete one");
}

bool is_above(uint64_t has, uint64_t more, uint64_t max) {
  return has > max || more > max - has;
}

Status no_history_room(const std::string& whose, uint64_t has, uint64_t more,
                       const std::string& key, uint64_t max) {
  return refuse(Refusal::kHistory, whose + " has " + std::to_string(has) +
                                       " bytes of history and needs " + std::to_string(more) +
                                       " more; " + key + " is " + std::to_string(max) +
                                       ". Undo still works; delete a session, or fork this one "
                                       "from an earlier edit");
}

uint64_t with_reserve(uint64_t max, bool takes_back) {
  return takes_back && max < UINT64_MAX - kHistoryReserveBytes ? max + kHistoryReserveBytes : max;
}

}  // namespace

Status check_session_room(const KeptLimits& limits, size_t sessions, const KeptShares& shares,
                          const Caller& caller) {
  if (sessions >= limits.sessions_max) return no_place(limits, sessions, 0);
  if (!caller.has_share()) return Status::ok();
  const size_t for_owners = std::min(limits.sessions_for_owners, limits.sessions_max / 2);
  if (sessions + for_owners >= limits.sessions_max) return no_place(limits, sessions, for_owners);
  const uint64_t has = shares.of(caller.user).sessions;
  if (has < limits.sessions_per_user) return Status::ok();
  return refuse(Refusal::kKeptSessions, "user " + caller.user + " has " + std::to_string(has) +
                                            " sessions, in memory or not; "
                                            "limits.kept_sessions_per_user is " +
                                            std::to_string(limits.sessions_per_user) +
                                            "; delete one");
}

Status check_history_room(const KeptLimits& limits, const HistoryGrowth& growth,
                          const KeptShares& shares, const Caller& caller) {
  if (!caller.has_share() || growth.more == 0) return Status::ok();
  const uint64_t session_max = with_reserve(limits.history_bytes_per_session, growth.takes_back);
  if (is_above(growth.has, growth.more, session_max))
    return no_history_room("the session", growth.has, growth.more,
                           "limits.history_bytes_per_session", limits.history_bytes_per_session);
  if (growth.maker.empty()) return Status::ok();
  const uint64_t all = shares.of(growth.maker).history_bytes;
  if (!is_above(all, growth.more, with_reserve(limits.history_bytes_per_user, growth.takes_back)))
    return Status::ok();
  return no_history_room("user " + growth.maker, all, growth.more, "limits.history_bytes_per_user",
                         limits.history_bytes_per_user);
}

}  // namespace burnish
