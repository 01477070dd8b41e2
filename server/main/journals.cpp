#include "server/main/journals.h"

#include <filesystem>
#include <iostream>
#include <optional>

#include <spdlog/spdlog.h>

#include "server/fleet/durability.h"
#include "server/fleet/pg_catalogue.h"
#include "server/journal/journal_copy.h"
#include "server/journal/sqlite_journal.h"
#include "server/journal/sqlite_schema.h"
#include "server/main/originals.h"
#include "server/solver/device_probe.h"

namespace burnish {

/// Says at the start what the database's settings may cost.
static Status warn_of_losses(const PgAddress& address, const ServerConfig& config) {
  ASSIGN_OR_RETURN(PgConnection database, PgConnection::open(address, {}, "burnish"));
  ASSIGN_OR_RETURN(const auto warnings,
                   durability_warnings(database, config.fleet_durability == "replicated"));
  for (const std::string& warning : warnings) spdlog::warn("journal: {}", warning);
  return Status::ok();
}

static bool give_spare(const DataFolder& folder) {
  if (!folder.give_spare()) return false;
  spdlog::warn("the disk of {} is full: the server starts with its spare room. Delete scans",
               folder.path().string());
  return true;
}

/// Opens the journal in a data folder, even if its disk is full. The room must be there before:
/// SQLite maps a file, whose holes end the program on a full disk, and tells other errors then. A
/// quota of the disk is seen afterwards alone.
static Result<std::unique_ptr<Journal>> open_journal_in(const DataFolder& folder) {
  const bool is_full = !folder.has_room_to_start() && !give_spare(folder);
  auto journal = SqliteJournal::open(folder.journal());
  if (journal.is_ok()) return journal;
  if (!is_full && journal.status().code() != StatusCode::kResourceExhausted) return journal;
  if (!is_full && give_spare(folder)) return SqliteJournal::open(folder.journal());
  return resource_exhausted(journal.status().message() +
                            ", and the spare room is used up: make room on the disk. What lies in "
                            "scans/*/prepared can be made again");
}

Result<OpenedJournal> open_journal_of(const ServerConfig& config, const DataFolder& folder) {
  OpenedJournal opened;
  if (config.journal.empty()) {
    ASSIGN_OR_RETURN(opened.journal, open_journal_in(folder));
    return opened;
  }
  ASSIGN_OR_RETURN(const PgAddress address, PgAddress::parse(config.journal));
  ASSIGN_OR_RETURN(auto journal, PostgresJournal::open(address, folder.paint()));
  opened.shared = journal.get();
  opened.journal = std::move(journal);
  RETURN_IF_ERROR(warn_of_losses(address, config));
  if (config.fleet_name.empty()) return opened;
  const LeaseTimes times{std::chrono::milliseconds(config.fleet_lease_ms),
                         std::chrono::milliseconds(config.fleet_heartbeat_ms),
                         std::chrono::milliseconds(config.fleet_alone_ms)};
  ASSIGN_OR_RETURN(opened.membership,
                   Membership::join(address, {config.fleet_name, config.fleet_advertise}, times));
  opened.watch = std::make_unique<HoldWatch>(
      times, [member = opened.membership.get()] { return member->lease_left(); });
  opened.shared->begin_life(opened.membership->first_life());
  return opened;
}

Status share_scans(const ServerConfig& config, const OpenedJournal& opened, MeshStore& store) {
  if (config.library_shared.empty()) return Status::ok();
  ASSIGN_OR_RETURN(const PgAddress address, PgAddress::parse(config.journal));
  SharedLibrary shared;
  ASSIGN_OR_RETURN(shared.originals, open_originals(config));
  ASSIGN_OR_RETURN(shared.catalogue, PgCatalogue::open(address));
  RETURN_IF_ERROR(store.share(std::move(shared)));
  opened.shared->share_scans();
  return Status::ok();
}

static NodeLoad load_of(const ServerConfig& config, SessionManager& sessions) {
  const Quota& memory = sessions.memory();
  return {has_device(config.backend) ? "cuda" : "cpu", memory.max(), memory.taken(),
          sessions.usage().in_memory};
}

std::jthread follow_fleet(const ServerConfig& config, const OpenedJournal& opened,
                          SessionManager& sessions, LiveSessions& live) {
  if (!opened.membership) return {};
  return opened.membership->start(
      {.on_new_life =
           [journal = opened.shared, &sessions](const std::string& life) {
             journal->begin_life(life);
             sessions.let_go(unavailable("the server was not heard for too long; come back"));
           },
       .load = [&config, &sessions] { return load_of(config, sessions); },
       .on_heartbeat =
           [&](std::vector<std::string> addresses) {
             sessions.refresh();
             const Status fresh = sessions.store().refresh_unless_busy();
             if (!fresh.is_ok()) spdlog::warn("the list of scans is old: {}", fresh.message());
             live.set_fleet(std::move(addresses));
           }});
}

Successors tell_fleet_of_drain(const OpenedJournal& opened) {
  std::vector<Successors::Server> servers;
  if (opened.membership)
    for (const FleetServer& server : opened.membership->drain())
      servers.push_back({server.place, server.bytes_free});
  return Successors(std::move(servers));
}

/// A journal without a server.
struct LoneJournal {
  std::unique_ptr<DataFolder> folder;  ///< null for a database
  std::unique_ptr<Journal> journal;    ///< ends first
};

/// Needs: a folder of a server, if it is a folder.
static Status check_source(const std::string& name) {
  if (is_pg_uri(name)) return Status::ok();
  const std::filesystem::path journal = DataFolder::journal_in(name);
  if (!std::filesystem::exists(journal))
    return not_found(name + ": is neither a data folder with a journal nor the URI of a database");
  ASSIGN_OR_RETURN(const bool is_journal, has_journal_schema(journal));
  return is_journal ? Status::ok() : data_loss(journal.string() + " is no journal of this program");
}

static Result<LoneJournal> open_lone_journal(const std::string& name) {
  LoneJournal opened;
  if (is_pg_uri(name)) {
    PostgresPatience patience;
    patience.connection.reply = std::chrono::minutes(10);  // a commit of everything
    ASSIGN_OR_RETURN(const PgAddress address, PgAddress::parse(name));
    ASSIGN_OR_RETURN(opened.journal, PostgresJournal::open(address, ":memory:", patience));
    return opened;
  }
  ASSIGN_OR_RETURN(opened.folder, DataFolder::open(name));
  ASSIGN_OR_RETURN(opened.journal, SqliteJournal::open(opened.folder->journal()));
  return opened;
}

Status copy_journal_of(const std::string& from, const std::string& to) {
  RETURN_IF_ERROR(check_source(from));
  ASSIGN_OR_RETURN(const LoneJournal source, open_lone_journal(from));
  ASSIGN_OR_RETURN(const LoneJournal target, open_lone_journal(to));
  ASSIGN_OR_RETURN(const JournalCopy copied, copy_journal(*source.journal, *target.journal));
  std::cout << copied.sessions << " sessions with " << copied.edits << " edits copied" << std::endl;
  return Status::ok();
}

}  // namespace burnish
