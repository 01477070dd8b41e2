#pragma once

#include <string>
#include <vector>

#include "common/service/session_info.h"

namespace burnish {

/// Returns the session in which a scan's editing goes on: the first of `recent` (names of sessions,
/// latest first) that edits the scan, else the scan's newest session. If it has none: a new one
/// with the scan's name, and with a number where the name is taken. Considers sessions of `depth`
/// alone; 0: of any.
SessionWish session_to_go_on(const ScanInfo& scan, const std::vector<SessionInfo>& sessions,
                             const std::vector<std::string>& recent, int depth = 0);

/// Returns the wish that joins a session.
SessionWish wish_to_join(const SessionInfo& session);

/// Returns a new session's wish, named by its scan. Depth 0 is the scan's default.
SessionWish new_session(const ScanInfo& scan, const std::vector<SessionInfo>& sessions,
                        int depth = 0);

}  // namespace burnish
