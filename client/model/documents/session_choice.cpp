#include "client/model/documents/session_choice.h"

#include <algorithm>

namespace burnish {

SessionWish wish_to_join(const SessionInfo& session) {
  return {.scan = session.scan_id, .name = session.name, .key = session.key};
}

static bool has_name(const std::vector<SessionInfo>& sessions, const std::string& name) {
  return std::any_of(sessions.begin(), sessions.end(),
                     [&](const SessionInfo& each) { return each.name == name; });
}

// Servers take such a name for an id.
static bool looks_like_an_id(const std::string& name) {
  return name.size() == 16 && name.find_first_not_of("0123456789abcdef") == std::string::npos;
}

SessionWish new_session(const ScanInfo& scan, const std::vector<SessionInfo>& sessions, int depth) {
  std::string name = scan.name;
  for (int number = 2; has_name(sessions, name) || looks_like_an_id(name); ++number)
    name = scan.name + " " + std::to_string(number);
  return {.scan = scan.id, .name = name, .key = {depth, 0}};
}

SessionWish session_to_go_on(const ScanInfo& scan, const std::vector<SessionInfo>& sessions,
                             const std::vector<std::string>& recent, int depth) {
  std::vector<SessionInfo> own;
  std::copy_if(sessions.begin(), sessions.end(), std::back_inserter(own),
               [&](const SessionInfo& each) {
                 return each.scan_id == scan.id && (depth == 0 || each.key.depth == depth);
               });
  if (own.empty()) return new_session(scan, sessions, depth);
  for (const std::string& name : recent)
    for (const SessionInfo& session : own)
      if (session.name == name) return wish_to_join(session);
  const auto older = [](const SessionInfo& a, const SessionInfo& b) {
    return a.created_unix_seconds < b.created_unix_seconds;
  };
  return wish_to_join(*std::max_element(own.begin(), own.end(), older));
}

}  // namespace burnish
