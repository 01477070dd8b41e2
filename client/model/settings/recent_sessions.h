#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "common/service/session_info.h"

namespace burnish {

inline constexpr size_t kRecentMax = 12;

/// A session that was open.
struct RecentSession {
  std::string server;  ///< empty: the private server of this machine
  std::string session;
  std::string scan;  ///< id
  std::string id;    ///< of the session; empty: an older version kept no id
  std::string scan_name;
  int64_t shown_unix_seconds = 0;
  uint64_t size_bytes = 0;  ///< of the scan on the server's disk
  bool operator==(const RecentSession&) const = default;
};

/// Returns true for two entries of one session.
bool is_same_session(const RecentSession& a, const RecentSession& b);

/// Puts an entry first and drops the oldest.
void remember(std::vector<RecentSession>& recent, const RecentSession& session);

/// Takes the names that sessions and scans of a server have now. Returns true if one has changed.
bool follow_names(std::vector<RecentSession>& recent, const std::string& server,
                  const std::vector<SessionInfo>& sessions, const std::vector<ScanInfo>& scans);

/// Returns the wish for a recent session. It finds the session by its id, also under a new name. A
/// session that is gone begins anew with the old name.
SessionWish session_of_recent(const RecentSession& recent,
                              const std::vector<SessionInfo>& sessions);

/// Returns the bytes that a scan takes on its server's disk.
uint64_t bytes_on_disk(const ScanInfo& scan);

}  // namespace burnish
