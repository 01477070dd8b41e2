#pragma once

#include <atomic>
#include <filesystem>
#include <memory>

#include "server/journal/group_commit.h"
#include "server/journal/journal.h"
#include "server/journal/journal_ends.h"

namespace burnish {

/// The journal of one server, in a file. An I/O error of a commit has an unknown outcome: the
/// write-ahead log may hold the whole commit, which SQLite finds after a crash.
class SqliteJournal final : public Journal {
 public:
  /// Also opens PATH with the extension .ends, see journal_ends.h. Fails: data_loss if the file is
  /// damaged or from a newer program; as SQLite says.
  static Result<std::unique_ptr<Journal>> open(const std::filesystem::path& path);

  ~SqliteJournal() override { ending_ = true; }

  Result<std::vector<SessionRecord>> sessions() override;
  Status create_session(const SessionRecord& record, const SessionRoles& roles) override;
  Status rename_session(const std::string& id, const std::string& name) override;
  Status remove_session(const std::string& id) override;
  Status hold(const std::string&) override { return Status::ok(); }  // the file has one server
  Status charge(const std::string&, const std::string&, uint64_t) override { return Status::ok(); }
  Result<std::optional<ServerPlace>> roomier_server(uint64_t) override {
    return std::optional<ServerPlace>();
  }
  void release(const std::string&) override {}
  bool is_shared() const override { return false; }
  Result<uint64_t> fork_session(const SessionRecord& source, uint64_t edits,
                                const SessionRecord& record, const SessionRoles& roles) override;
  using Journal::append;
  void append(const std::string& session_id, uint64_t first, std::vector<AuthoredEdit> edits,
              Done done) override;
  Result<std::vector<AuthoredEdit>> edits(const std::string& session_id) override;
  Result<uint64_t> history_bytes(const std::string& session_id) override;
  Result<uint64_t> edit_count(const std::string& session_id) override;
  Result<SessionRoles> roles(const std::string& session_id) override;
  Status set_role(const std::string& session_id, const std::string& user,
                  SessionRole role) override;
  Status enter_all(const NextSession& next) override;
  void keep_paint(const std::string& session_id, const PaintCheckpoint& paint) override;
  Result<std::vector<PaintCheckpoint>> paint(const std::string& session_id,
                                             size_t cell_count) override;
  uint64_t commits() const override { return commit_.commits(); }

 private:
  SqliteJournal(Database database, std::unique_ptr<JournalEnds> ends)
      : ends_(std::move(ends)), commit_(std::move(database)) {}

  template <typename T>
  Result<T> read(const std::function<Result<T>(Database&)>& work);

  /// Gives the disk space of removed sessions back, a megabyte per commit.
  void shrink();

  std::atomic<bool> ending_{false};
  std::unique_ptr<JournalEnds> ends_;  // must outlive the commits
  GroupCommit commit_;
};

}  // namespace burnish
