#pragma once

#include <memory>
#include <string>
#include <thread>

#include "common/base/status.h"
#include "server/config/config.h"
#include "server/fleet/hold_watch.h"
#include "server/fleet/membership.h"
#include "server/journal/postgres_journal.h"
#include "server/library/data_folder.h"
#include "server/library/mesh_store.h"
#include "server/live/live_sessions.h"
#include "server/manager/session_manager.h"

namespace burnish {

/// A journal, and this server's place among those that share it.
struct OpenedJournal {
  std::unique_ptr<Membership> membership;  ///< null for a server that is alone; ends after the rest
  std::unique_ptr<HoldWatch> watch;        ///< likewise null
  std::unique_ptr<Journal> journal;
  PostgresJournal* shared = nullptr;  ///< the same journal; null for a file
};

/// Opens the journal of the configuration, and joins the fleet of its name. Fails: as they say.
Result<OpenedJournal> open_journal_of(const ServerConfig& config, const DataFolder& folder);

/// Shares the scans with the other servers if the configuration says so. Fails: as
/// MeshStore::share() and open_originals() say; unavailable.
Status share_scans(const ServerConfig& config, const OpenedJournal& opened, MeshStore& store);

/// Renews the server's lease, follows what other servers do to the sessions, and tells clients of
/// the fleet, while the returned thread lives.
[[nodiscard]] std::jthread follow_fleet(const ServerConfig& config, const OpenedJournal& opened,
                                        SessionManager& sessions, LiveSessions& live);

/// Tells the fleet that this server drains. Returns the servers that take its sessions; none for a
/// server that is alone.
Successors tell_fleet_of_drain(const OpenedJournal& opened);

/// Copies a journal, and says how much it was. Each name is a data folder, which is locked
/// meanwhile, or the URI of a database. Fails: as copy_journal() and the journals say.
Status copy_journal_of(const std::string& from, const std::string& to);

}  // namespace burnish
