#include "client/model/settings/recent_sessions.h"

#include <algorithm>

namespace burnish {

bool is_same_session(const RecentSession& a, const RecentSession& b) {
  if (a.server != b.server) return false;
  return a.id.empty() || b.id.empty() ? a.session == b.session : a.id == b.id;
}

void remember(std::vector<RecentSession>& recent, const RecentSession& session) {
  std::erase_if(recent, [&](const RecentSession& each) { return is_same_session(each, session); });
  recent.insert(recent.begin(), session);
  if (recent.size() > kRecentMax) recent.resize(kRecentMax);
}

template <typename Info>
static const Info* find_id(const std::vector<Info>& infos, const std::string& id) {
  const auto found =
      std::find_if(infos.begin(), infos.end(), [&](const Info& each) { return each.id == id; });
  return found == infos.end() ? nullptr : &*found;
}

bool follow_names(std::vector<RecentSession>& recent, const std::string& server,
                  const std::vector<SessionInfo>& sessions, const std::vector<ScanInfo>& scans) {
  const std::vector<RecentSession> before = recent;
  for (RecentSession& each : recent) {
    if (each.server != server) continue;
    if (const SessionInfo* session = find_id(sessions, each.id)) each.session = session->name;
    if (const ScanInfo* scan = find_id(scans, each.scan)) {
      each.scan_name = scan->name;
      each.size_bytes = bytes_on_disk(*scan);
    }
  }
  return recent != before;
}

SessionWish session_of_recent(const RecentSession& recent,
                              const std::vector<SessionInfo>& sessions) {
  const SessionInfo* const session = find_id(sessions, recent.id);
  if (!session) return {.scan = recent.scan, .name = recent.session};
  return {.scan = session->scan_id, .name = session->name, .key = session->key};
}

uint64_t bytes_on_disk(const ScanInfo& scan) {
  uint64_t bytes = scan.size_bytes;
  for (const PreparedInfo& prepared : scan.prepared) bytes += prepared.size_bytes;
  return bytes;
}

}  // namespace burnish
