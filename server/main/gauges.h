#pragma once

#include <vector>

#include "server/fleet/membership.h"
#include "server/library/mesh_store.h"
#include "server/live/live_sessions.h"
#include "server/manager/session_manager.h"
#include "server/metrics/prometheus/exporter.h"
#include "server/rpc/server.h"

namespace burnish {

/// Reads the server's present figures: calls, sessions, bytes, the disk, live objects, the
/// certificate's end.
/// `certificates` and `membership` may be null.
std::vector<Gauge> read_gauges(const Server& server, const DataFolder& folder, MeshStore& store,
                               const SessionManager& sessions, const LiveSessions& live,
                               const Reloaded<Certificates>* certificates,
                               const Membership* membership);

}  // namespace burnish
