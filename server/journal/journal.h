#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "common/base/server_place.h"
#include "common/edit/controls.h"
#include "common/edit/edit.h"
#include "common/service/scan_info.h"
#include "common/service/session_roles.h"
#include "server/fields/paint_checkpoints.h"
#include "server/journal/write_outcome.h"

namespace burnish {

/// Memory of an edit beside the bytes of its row.
inline constexpr uint64_t kHistoryBytesOfARow = 640;

/// The facts of a session apart from its edits.
struct SessionRecord {
  std::string id;
  std::string name;
  std::string scan_id;
  PreparedKey key;
  int64_t created_unix_seconds = 0;
  Controls controls;        ///< the initial ones: none from before there were controls
  bool is_damaged = false;  ///< when read: no value can be trusted
  /// The user who made it, "" for nobody with a name. Null if the journal does not say: a program
  /// from before wrote the row, or this part of it is damaged.
  std::optional<std::string> maker = {};
};

/// A session with all that a journal must keep of it.
struct KeptSession {
  SessionRecord record;
  SessionRoles roles;
  std::vector<AuthoredEdit> edits;
};

/// Returns one session after the other, and nothing behind the last.
using NextSession = std::function<Result<std::optional<KeptSession>>()>;

/// The sessions and their edits, on disk before anybody is told. It keeps edits, never solutions:
/// applying a session's edits in order gives its state. The paint beside them only makes that
/// faster. Every row has a checksum, so a read finds a row that is damaged or missing. Thread-safe;
/// writes share commits. The destructor writes all that the journal was given, and returns when
/// every `done` has returned. Whatever they use must outlive the journal.
///
/// A write that returns a Status fails with `unavailable` if nobody knows whether it is on disk.
class Journal {
 public:
  using Done = std::function<void(const WriteOutcome&)>;

  virtual ~Journal() = default;

  /// Returns the sessions by name. Damaged ones are marked and logged.
  virtual Result<std::vector<SessionRecord>> sessions() = 0;

  /// Fails: already_exists (another session has the id or the name).
  virtual Status create_session(const SessionRecord& record, const SessionRoles& roles) = 0;
  /// Fails: already_exists (another session has the name), data_loss (the session's row is
  /// damaged), not_found; as hold() if the session is not held.
  virtual Status rename_session(const std::string& id, const std::string& name) = 0;
  /// Fails: as hold() if the session is there and not held.
  virtual Status remove_session(const std::string& id) = 0;

  /// Makes this server the only one that writes the session, until another one holds it. A session
  /// is held from its making on. Appends to a session that is not held have an unknown outcome.
  /// Fails: failed_precondition with Status::moved() (another server holds it); not_found;
  /// unavailable.
  virtual Status hold(const std::string& session_id) = 0;

  /// Counts a held session for the user who has it brought to memory, over all servers that write
  /// here. Does nothing for "", and for a journal of one server. Fails: resource_exhausted (the
  /// user has `sessions_max` others); as hold() if the session is not held.
  virtual Status charge(const std::string& session_id, const std::string& user,
                        uint64_t sessions_max) = 0;

  /// Returns the server with the most free memory, if it has more than `bytes`, and is not this
  /// one.
  virtual Result<std::optional<ServerPlace>> roomier_server(uint64_t bytes) = 0;

  /// Lets go of a session that this server does not use. Does not wait.
  virtual void release(const std::string& session_id) = 0;

  /// Returns whether other servers write here too.
  virtual bool is_shared() const = 0;

  /// Makes a session with the first `edits` edits of another session, and its paint. At another
  /// depth there are other cells: paint is left out, and edits that set single cells set none.
  /// Returns the number of these edits.
  virtual Result<uint64_t> fork_session(const SessionRecord& source, uint64_t edits,
                                        const SessionRecord& record, const SessionRoles& roles) = 0;

  /// Appends all edits or none; the first gets the number `first`. Another thread calls `done` with
  /// the outcome. Without edits it only waits for earlier ones. Refuses with already_exists (the
  /// author has used an id before) and data_loss (the session's edits do not end before `first`,
  /// because some were not written). `done` must not wait for this object.
  virtual void append(const std::string& session_id, uint64_t first,
                      std::vector<AuthoredEdit> edits, Done done) = 0;

  /// Does the same and waits.
  WriteOutcome append(const std::string& session_id, uint64_t first,
                      std::vector<AuthoredEdit> edits);

  /// Returns the edits in the order of their numbers, with a Damaged edit in place of a damaged
  /// one. Fails: data_loss if the session's record or the whole journal is damaged.
  virtual Result<std::vector<AuthoredEdit>> edits(const std::string& session_id) = 0;

  /// Returns the number of edits, damaged ones included, after all earlier appends.
  virtual Result<uint64_t> edit_count(const std::string& session_id) = 0;

  /// Returns about the bytes of the edits in memory, from the sizes of their rows.
  virtual Result<uint64_t> history_bytes(const std::string& session_id) = 0;

  /// Returns the number of the edit that last gave a checkpoint this name. Fails: not_found, as
  /// edits().
  Result<uint64_t> checkpoint(const std::string& session_id, const std::string& name);

  /// A damaged role reads as the least role.
  virtual Result<SessionRoles> roles(const std::string& session_id) = 0;
  /// Fails: as hold() if the session is not held.
  virtual Status set_role(const std::string& session_id, const std::string& user,
                          SessionRole role) = 0;

  /// Enters sessions in one transaction: all or none. A damaged edit stays damaged. Fails: as
  /// `next` and create_session().
  virtual Status enter_all(const NextSession& next) = 0;

  /// Keeps paint of a session; drops the oldest beyond a few. Does not wait, has its own commit,
  /// and logs a failure.
  virtual void keep_paint(const std::string& session_id, const PaintCheckpoint& paint) = 0;

  /// Returns the kept paint, without damaged paint.
  virtual Result<std::vector<PaintCheckpoint>> paint(const std::string& session_id,
                                                     size_t cell_count) = 0;

  /// Returns the number of commits so far. Tests check with it that writes share commits.
  virtual uint64_t commits() const = 0;
};

}  // namespace burnish
