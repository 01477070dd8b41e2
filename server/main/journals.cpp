#include "server/main/journals.h"

#include <iostream>
#include <optional>

#include "server/journal/journal_copy.h"
#include "server/journal/sqlite_journal.h"

namespace burnish {

Result<OpenedJournal> open_journal_of(const ServerConfig& config, const DataFolder& folder) {
  OpenedJournal opened;
  if (config.journal.empty()) {
    ASSIGN_OR_RETURN(opened.journal, SqliteJournal::open(folder.journal()));
    return opened;
  }
  ASSIGN_OR_RETURN(const PgAddress address, PgAddress::parse(config.journal));
  ASSIGN_OR_RETURN(auto journal, PostgresJournal::open(address, folder.paint()));
  opened.shared = journal.get();
  opened.journal = std::move(journal);
  if (config.fleet_name.empty()) return opened;
  const LeaseTimes times{std::chrono::milliseconds(config.fleet_lease_ms),
                         std::chrono::milliseconds(config.fleet_heartbeat_ms)};
  ASSIGN_OR_RETURN(opened.membership,
                   Membership::join(address, {config.fleet_name, config.fleet_advertise}, times));
  opened.shared->begin_life(opened.membership->first_life());
  return opened;
}

std::jthread follow_fleet(const OpenedJournal& opened, SessionManager& sessions,
                          LiveSessions& live) {
  if (!opened.membership) return {};
  return opened.membership->start(
      {.on_new_life =
           [journal = opened.shared, &sessions](const std::string& life) {
             journal->begin_life(life);
             sessions.let_go(unavailable("the server was not heard for too long; come back"));
           },
       .on_heartbeat =
           [&](std::vector<std::string> addresses) {
             sessions.refresh();
             live.set_fleet(std::move(addresses));
           }});
}

/// A journal without a server.
struct LoneJournal {
  std::unique_ptr<DataFolder> folder;  ///< null for a database
  std::unique_ptr<Journal> journal;    ///< ends first
};

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
  ASSIGN_OR_RETURN(const LoneJournal source, open_lone_journal(from));
  ASSIGN_OR_RETURN(const LoneJournal target, open_lone_journal(to));
  ASSIGN_OR_RETURN(const JournalCopy copied, copy_journal(*source.journal, *target.journal));
  std::cout << copied.sessions << " sessions with " << copied.edits << " edits copied" << std::endl;
  return Status::ok();
}

}  // namespace burnish
