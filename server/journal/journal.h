#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "common/edit/edit.h"
#include "common/service/scan_info.h"
#include "common/service/session_roles.h"
#include "server/fields/paint_checkpoints.h"
#include "server/journal/group_commit.h"
#include "server/journal/journal_ends.h"

namespace burnish {

/// What a session is, apart from its edits.
struct SessionRecord {
  std::string id;
  std::string name;
  std::string scan_id;
  PreparedKey key;
  int64_t created_unix_seconds = 0;
  bool is_damaged = false;  ///< as it was read: no value can be relied on
};

/// The sessions and their edits, on disk before anybody is told. It keeps intentions, never
/// solutions: applying a session's edits in order gives its state. The paint that it keeps beside
/// them only shortens that. Every row has a checksum; a row that is damaged or gone is found when
/// it is read. Thread-safe; writes share commits.
class Journal {
 public:
  /// Beside it stands PATH with the extension .ends, see journal_ends.h.
  /// Fails: data_loss when the file is damaged or from a newer program; as SQLite says.
  static Result<std::unique_ptr<Journal>> open(const std::filesystem::path& path);

  /// Writes what it was given, and returns when every `done` has: whatever they use must outlive
  /// the journal.
  ~Journal() { ending_ = true; }

  /// By name. Damaged ones are marked and logged.
  Result<std::vector<SessionRecord>> sessions();

  Status create_session(const SessionRecord& record, const SessionRoles& roles);
  Status remove_session(const std::string& id);

  /// A new session with the first `edits` edits of another, and its paint.
  Status fork_session(const std::string& source_id, uint64_t edits, const SessionRecord& record,
                      const SessionRoles& roles);

  /// Appends all or none, the first with the number `first`; `done` is called from another thread
  /// when they are on disk. Without edits it only waits for those before.
  /// Fails: already_exists (an id that the author has used), data_loss (the session's edits do not
  /// end before `first`, for some before were not written).
  void append(const std::string& session_id, uint64_t first, std::vector<AuthoredEdit> edits,
              GroupCommit::Done done);

  /// The same, and waits.
  Status append(const std::string& session_id, uint64_t first, std::vector<AuthoredEdit> edits);

  /// In the order of their numbers. In the place of one that is damaged stands a Damaged one.
  /// Fails: data_loss when the session's record is damaged, or the file as a whole.
  Result<std::vector<AuthoredEdit>> edits(const std::string& session_id);

  /// With those that are damaged, after all that was appended before.
  Result<uint64_t> edit_count(const std::string& session_id);

  /// The number of the edit that last gave a checkpoint this name. Fails: not_found, as edits().
  Result<uint64_t> checkpoint(const std::string& session_id, const std::string& name);

  /// A role that is damaged is the least that there is.
  Result<SessionRoles> roles(const std::string& session_id);
  Status set_role(const std::string& session_id, const std::string& user, SessionRole role);

  /// Keeps paint of a session; its oldest goes when there is more than a few. Does not wait, has
  /// a commit of its own, and is logged when it fails.
  void keep_paint(const std::string& session_id, const PaintCheckpoint& paint);

  /// What is kept, without what is damaged.
  Result<std::vector<PaintCheckpoint>> paint(const std::string& session_id, size_t cell_count);

  /// Commits so far, by which a test sees that writes share them.
  uint64_t commits() const { return commit_.commits(); }

 private:
  Journal(Database database, std::unique_ptr<JournalEnds> ends)
      : ends_(std::move(ends)), commit_(std::move(database)) {}

  template <typename T>
  Result<T> read(const std::function<Result<T>(Database&)>& work);

  /// Gives the disk back what removed sessions took, a megabyte a commit.
  void shrink();

  std::atomic<bool> ending_{false};
  std::unique_ptr<JournalEnds> ends_;  // outlives the commits
  GroupCommit commit_;
};

}  // namespace burnish
