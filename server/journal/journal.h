#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "common/edit/controls.h"
#include "common/edit/edit.h"
#include "common/service/scan_info.h"
#include "common/service/session_roles.h"
#include "server/fields/paint_checkpoints.h"
#include "server/journal/group_commit.h"
#include "server/journal/journal_ends.h"

namespace burnish {

/// The facts of a session apart from its edits.
struct SessionRecord {
  std::string id;
  std::string name;
  std::string scan_id;
  PreparedKey key;
  int64_t created_unix_seconds = 0;
  Controls controls;        ///< that it was born with: none from before there were controls
  bool is_damaged = false;  ///< when read: no value can be trusted
};

/// The sessions and their edits, on disk before anybody is told. It keeps edits, never solutions:
/// applying a session's edits in order gives its state. The paint beside them only makes that
/// faster. Every row has a checksum, so a read finds a row that is damaged or missing. Thread-safe;
/// writes share commits.
class Journal {
 public:
  /// Also opens PATH with the extension .ends, see journal_ends.h. Fails: data_loss if the file is
  /// damaged or from a newer program; as SQLite says.
  static Result<std::unique_ptr<Journal>> open(const std::filesystem::path& path);

  /// Writes all that it was given, and returns when every `done` has returned. Whatever they use
  /// must outlive the journal.
  ~Journal() { ending_ = true; }

  /// Returns the sessions by name. Damaged ones are marked and logged.
  Result<std::vector<SessionRecord>> sessions();

  Status create_session(const SessionRecord& record, const SessionRoles& roles);
  /// Fails: already_exists (another session has the name), data_loss (the session's row is
  /// damaged), not_found.
  Status rename_session(const std::string& id, const std::string& name);
  Status remove_session(const std::string& id);

  /// Makes a session with the first `edits` edits of another session, and its paint. At another
  /// depth there are other cells: paint is left out, and edits that set single cells set none.
  /// Returns the number of these edits.
  Result<uint64_t> fork_session(const SessionRecord& source, uint64_t edits,
                                const SessionRecord& record, const SessionRoles& roles);

  /// Appends all edits or none; the first gets the number `first`. Another thread calls `done` when
  /// they are on disk. Without edits it only waits for earlier ones. Fails: already_exists (the
  /// author has used an id before), data_loss (the session's edits do not end before `first`,
  /// because some were not written).
  void append(const std::string& session_id, uint64_t first, std::vector<AuthoredEdit> edits,
              GroupCommit::Done done);

  /// Does the same and waits.
  Status append(const std::string& session_id, uint64_t first, std::vector<AuthoredEdit> edits);

  /// Returns the edits in the order of their numbers, with a Damaged edit in place of a damaged
  /// one. Fails: data_loss if the session's record or the whole file is damaged.
  Result<std::vector<AuthoredEdit>> edits(const std::string& session_id);

  /// Returns the number of edits, damaged ones included, after all earlier appends.
  Result<uint64_t> edit_count(const std::string& session_id);

  /// Returns the number of the edit that last gave a checkpoint this name. Fails: not_found, as
  /// edits().
  Result<uint64_t> checkpoint(const std::string& session_id, const std::string& name);

  /// A damaged role reads as the least role.
  Result<SessionRoles> roles(const std::string& session_id);
  Status set_role(const std::string& session_id, const std::string& user, SessionRole role);

  /// Keeps paint of a session; drops the oldest beyond a few. Does not wait, has its own commit,
  /// and logs a failure.
  void keep_paint(const std::string& session_id, const PaintCheckpoint& paint);

  /// Returns the kept paint, without damaged paint.
  Result<std::vector<PaintCheckpoint>> paint(const std::string& session_id, size_t cell_count);

  /// Returns the number of commits so far. Tests check with it that writes share commits.
  uint64_t commits() const { return commit_.commits(); }

 private:
  Journal(Database database, std::unique_ptr<JournalEnds> ends)
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
