#pragma once

#include <memory>
#include <utility>

#include "server/journal/journal.h"

namespace burnish {

/// Another journal, whose appends can end with an unknown outcome.
class DoubtfulJournal final : public Journal {
 public:
  enum class Doubt {
    kNothing,
    kWritten,  ///< the append is done, and its outcome is unknown
    kLost,     ///< the append is not done, and its outcome is unknown
  };

  explicit DoubtfulJournal(std::unique_ptr<Journal> real) : real_(std::move(real)) {}

  Doubt next = Doubt::kNothing;  ///< of the next append

  using Journal::append;
  void append(const std::string& session_id, uint64_t first, std::vector<AuthoredEdit> edits,
              Done done) override {
    const Doubt doubt = std::exchange(next, Doubt::kNothing);
    if (doubt == Doubt::kLost) edits.clear();
    real_->append(
        session_id, first, std::move(edits),
        [doubt, done = std::move(done)](const WriteOutcome& outcome) {
          done(doubt == Doubt::kNothing ? outcome : WriteOutcome::unknown(internal_error("sync")));
        });
  }

  Result<std::vector<SessionRecord>> sessions() override { return real_->sessions(); }
  Status create_session(const SessionRecord& record, const SessionRoles& roles) override {
    return real_->create_session(record, roles);
  }
  Status rename_session(const std::string& id, const std::string& name) override {
    return real_->rename_session(id, name);
  }
  Status hold(const std::string& id) override { return real_->hold(id); }
  Status charge(const std::string& id, const std::string& user, uint64_t sessions_max) override {
    return real_->charge(id, user, sessions_max);
  }
  Result<std::optional<ServerPlace>> roomier_server(uint64_t bytes) override {
    return real_->roomier_server(bytes);
  }
  void release(const std::string& id) override { real_->release(id); }
  bool is_shared() const override { return real_->is_shared(); }
  Status remove_session(const std::string& id) override { return real_->remove_session(id); }
  Result<uint64_t> fork_session(const SessionRecord& source, uint64_t edits,
                                const SessionRecord& record, const SessionRoles& roles) override {
    return real_->fork_session(source, edits, record, roles);
  }
  Result<std::vector<AuthoredEdit>> edits(const std::string& id) override {
    return real_->edits(id);
  }
  Result<uint64_t> edit_count(const std::string& id) override { return real_->edit_count(id); }
  Result<uint64_t> history_bytes(const std::string& id) override {
    return real_->history_bytes(id);
  }
  Result<SessionRoles> roles(const std::string& id) override { return real_->roles(id); }
  Status set_role(const std::string& id, const std::string& user, SessionRole role) override {
    return real_->set_role(id, user, role);
  }
  Status enter_all(const NextSession& each) override { return real_->enter_all(each); }
  void keep_paint(const std::string& id, const PaintCheckpoint& paint) override {
    real_->keep_paint(id, paint);
  }
  Result<std::vector<PaintCheckpoint>> paint(const std::string& id, size_t cell_count) override {
    return real_->paint(id, cell_count);
  }
  uint64_t commits() const override { return real_->commits(); }

 private:
  const std::unique_ptr<Journal> real_;
};

}  // namespace burnish
