#pragma once

#include <vector>

#include "server/metrics/prometheus/exporter.h"
#include "server/rpc/server.h"
#include "server/session/live_sessions.h"
#include "server/session/mesh_store.h"
#include "server/session/session_manager.h"

namespace burnish {

/// What the server has just now: calls, sessions, bytes, live objects, the certificate's end.
/// `certificates` may be null.
std::vector<Gauge> read_gauges(const Server& server, MeshStore& store,
                               const SessionManager& sessions, const LiveSessions& live,
                               const Reloaded<Certificates>* certificates);

}  // namespace burnish
