#pragma once

#include <string>
#include <vector>

#include "common/service/session_info.h"

namespace burnish {

/// Returns the session in which a scan's editing goes on: the first of `recent` (names of sessions,
/// latest first) that edits the scan, else the scan's newest session. If it has none: a new one
/// with the scan's name, and with a number where the name is taken.
SessionWish session_to_go_on(const ScanInfo& scan, const std::vector<SessionInfo>& sessions,
                             const std::vector<std::string>& recent);

/// Returns a new session's wish, named by its scan.
SessionWish new_session(const ScanInfo& scan, const std::vector<SessionInfo>& sessions);

}  // namespace burnish
