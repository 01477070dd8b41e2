#include "server/main/gauges.h"

#include "common/base/process_memory.h"
#include "server/metrics/live_objects.h"
#include "server/solver/cuda/cuda_backend.h"

namespace burnish {

std::vector<Gauge> read_gauges(const Server& server, const DataFolder& folder, MeshStore& store,
                               const SessionManager& sessions, const LiveSessions& live,
                               const Reloaded<Certificates>* certificates,
                               const Membership* membership) {
  const SessionManager::Usage usage = sessions.usage();
  const KeptShares::Share share = sessions.largest_share();
  const LiveSessions::Usage live_usage = live.usage();
  const auto number = [](auto value) { return static_cast<double>(value); };
  std::vector<Gauge> gauges = {
      {"burnish_running_rpcs", "RPCs in progress", number(server.running_calls())},
      {"burnish_web_connections", "Connections of browsers", number(server.web_connections())},
      {"burnish_sessions", "Sessions that the journal knows", number(sessions.list().size())},
      {"burnish_user_sessions_max", "Sessions of the user who has most, in memory or not",
       number(share.sessions)},
      {"burnish_user_history_bytes_max", "Bytes of history of the user who has most",
       number(share.history_bytes)},
      {"burnish_open_sessions", "Sessions in memory", number(usage.in_memory)},
      {"burnish_live_waiting_sessions", "Live sessions that wait for their turn to solve",
       number(live_usage.waiting_sessions)},
      {"burnish_live_queued_edits", "Messages of edits that wait for their session's turn",
       number(live_usage.queued_edits)},
      {"burnish_live_credits", "Frames that clients are ready for", number(live_usage.credits)},
      {"burnish_session_bytes", "Predicted bytes of the sessions in memory, without meshes",
       number(usage.session_bytes)},
      {"burnish_client_bytes", "Bytes of frames held for the clients of sessions",
       number(live_usage.client_bytes)},
      {"burnish_prepared_bytes", "Bytes of the prepared meshes and hierarchies in use",
       number(store.mesh_bytes())},
      {"burnish_memory_taken_bytes", "Bytes of memory_bytes_max that admission has given out",
       number(store.memory().taken())},
      {"burnish_memory_max_bytes", "limits.memory_bytes_max", number(store.memory().max())},
      {"burnish_device_memory_bytes", "Bytes of GPU memory that meshes and sessions use",
       number(cuda_memory_used())},
      {"burnish_disk_free_bytes", "Free bytes of the data folder's disk",
       number(folder.free_bytes())},
      {"burnish_resident_bytes", "Resident memory of the process", number(resident_bytes())},
  };
  if (membership)
    gauges.push_back({"burnish_fleet_lease_seconds_left",
                      "Until others may have this server's sessions, without another heartbeat",
                      membership->lease_left().count()});
  if (certificates)
    gauges.push_back({"burnish_certificate_expires_unix_seconds",
                      "When the server's certificate ends",
                      number(certificates->get()->expires_unix_seconds)});
  for (const LiveKind kind : kLiveKinds)
    gauges.push_back({"burnish_live_objects", "Objects alive, by kind", number(live_count(kind)),
                      "kind", std::string(live_kind_name(kind))});
  return gauges;
}

}  // namespace burnish
