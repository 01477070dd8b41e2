#include "server/main/journals.h"

#include <iostream>
#include <optional>

#include "server/journal/journal_copy.h"
#include "server/journal/postgres_journal.h"
#include "server/journal/sqlite_journal.h"

namespace burnish {

static Result<std::unique_ptr<Journal>> open_database(const std::string& uri,
                                                      const std::filesystem::path& paint,
                                                      const PostgresPatience& patience) {
  ASSIGN_OR_RETURN(const PgAddress address, PgAddress::parse(uri));
  ASSIGN_OR_RETURN(auto journal, PostgresJournal::open(address, paint, patience));
  return std::unique_ptr<Journal>(std::move(journal));
}

Result<std::unique_ptr<Journal>> open_journal(const std::string& uri, const DataFolder& folder) {
  if (uri.empty()) return SqliteJournal::open(folder.journal());
  return open_database(uri, folder.paint(), {});
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
    ASSIGN_OR_RETURN(opened.journal, open_database(name, ":memory:", patience));
    return opened;
  }
  ASSIGN_OR_RETURN(opened.folder, DataFolder::open(name));
  ASSIGN_OR_RETURN(opened.journal, open_journal("", *opened.folder));
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
