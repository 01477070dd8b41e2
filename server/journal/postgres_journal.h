#pragma once

#include <atomic>
#include <filesystem>
#include <memory>

#include "server/journal/journal.h"
#include "server/journal/paint_cache.h"
#include "server/journal/postgres_queue.h"

namespace burnish {

/// A journal in a PostgreSQL database, which several servers may share. The tables are in the
/// schema `burnish`. Paint stays on the server's own disk.
class PostgresJournal final : public Journal {
 public:
  /// `paint`: the file of kept paint. Makes or updates the tables. Fails: data_loss for a journal
  /// of a newer program; unavailable.
  static Result<std::unique_ptr<PostgresJournal>> open(const PgAddress& address,
                                                       const std::filesystem::path& paint,
                                                       const PostgresPatience& patience = {});

  Result<std::vector<SessionRecord>> sessions() override;
  Status create_session(const SessionRecord& record, const SessionRoles& roles) override;
  Status rename_session(const std::string& id, const std::string& name) override;
  Status remove_session(const std::string& id) override;
  Status hold(const std::string& session_id) override;
  Status charge(const std::string& session_id, const std::string& user,
                uint64_t sessions_max) override;
  Result<std::optional<ServerPlace>> roomier_server(uint64_t bytes) override;
  void release(const std::string& session_id) override;
  bool is_shared() const override { return is_shared_; }

  /// From now on new sessions need a scan that is in the catalogue of scans, and it stays there
  /// while they exist. Needs: one call, before others.
  void share_scans() { shares_scans_ = true; }

  /// From now on this server is a member of a fleet, with this life. It holds no session then.
  void begin_life(const std::string& life);
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
  void keep_paint(const std::string& session_id, const PaintCheckpoint& paint) override {
    paint_->keep(session_id, paint);
  }
  Result<std::vector<PaintCheckpoint>> paint(const std::string& session_id,
                                             size_t cell_count) override {
    return paint_->read(session_id, cell_count);
  }
  uint64_t commits() const override { return queue_->commits(); }

 private:
  PostgresJournal(std::unique_ptr<PostgresQueue> queue, std::unique_ptr<PaintCache> paint)
      : paint_(std::move(paint)), queue_(std::move(queue)) {}

  template <typename T>
  Result<T> read(const std::function<Result<T>(PgConnection&)>& work);

  std::atomic<bool> is_shared_{false};
  std::atomic<bool> shares_scans_{false};
  std::unique_ptr<PaintCache> paint_;
  std::unique_ptr<PostgresQueue> queue_;  // its thread ends first
};

}  // namespace burnish
