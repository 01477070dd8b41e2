#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <unordered_set>
#include <vector>

#include "common/base/status.h"
#include "common/edit/edit.h"

namespace burnish {

/// The list of a session's entries, each on or off. An entry is an edit that makes fields, or a
/// checkpoint. Undo, redo, switches and restored checkpoints only change which entries are on. The
/// same edits in the same order give the same history.
///
/// A damaged edit is an entry that is never on. Undo, redo and switches from before the damage
/// count it as good, so they still mean the same entries.
class History {
 public:
  struct Entry {
    uint64_t number;  ///< of the edit that made it, from 1 over all edits of the session
    std::shared_ptr<const AuthoredEdit> made_by;
    bool enabled = true;       ///< also for a damaged one: undo would switch it off
    uint64_t stroke_hash = 0;  ///< hash of what it paints, see paint_checkpoints.h

    bool is_damaged() const { return kind_of(made_by->edit) == EditKind::kDamaged; }
    bool is_on() const { return enabled && !is_damaged(); }
  };

  /// Returns the number of edits so far; the next one's number is one more.
  uint64_t size() const { return steps_.size(); }

  bool knows(const std::string& author, const std::string& edit_id) const;

  /// Returns the number of the entry that the edit made or switched, 0 for a restored checkpoint.
  /// Needs: an id that the author has not used. A failed edit changes nothing. Fails:
  /// failed_precondition (nothing to undo or redo), not_found (no such entry or checkpoint),
  /// invalid_argument (a checkpoint cannot be switched, nor a damaged entry be switched on).
  Result<uint64_t> apply(AuthoredEdit edit);

  /// Takes an edit of an earlier history. Returns false if it has no effect any more, because it is
  /// damaged or needs a damaged one; it still takes its number.
  bool restore(AuthoredEdit edit);

  /// Forgets the last edit as if it had never been.
  void take_back();

  /// Returns the bytes of the edits in memory, see bytes_in_history().
  uint64_t byte_count() const { return byte_count_; }

  /// Returns the entries by number.
  const std::vector<Entry>& entries() const { return entries_; }

  /// Returns the number of the edit that last gave a checkpoint this name. Fails: not_found.
  Result<uint64_t> checkpoint(const std::string& name) const;

 private:
  /// One applied edit and the data to forget it.
  struct Step {
    std::shared_ptr<const AuthoredEdit> edit;
    std::vector<uint64_t> switched;  // entries
    std::vector<uint64_t> not_redoable;
  };
  struct Author {
    std::set<uint64_t> enabled;    // entries that make fields
    std::vector<uint64_t> undone;  // entries in the order of their undoing
  };

  Result<uint64_t> enter(Step step);
  Status check_switch(const Edit& edit) const;

  // Each returns the result of apply().
  template <typename MakesFields>
  Result<uint64_t> apply_change(const MakesFields&, Step& step) {
    return add_entry(step);
  }
  Result<uint64_t> apply_change(const Undo&, Step& step);
  Result<uint64_t> apply_change(const Redo&, Step& step);
  Result<uint64_t> apply_change(const SwitchEntry& change, Step& step);
  Result<uint64_t> apply_change(const SetCheckpoint& change, Step& step);
  Result<uint64_t> apply_change(const RestoreCheckpoint& change, Step& step);

  static uint64_t byte_count(const Step& step);
  uint64_t add_entry(Step& step);
  void toggle(uint64_t number);
  const Entry* find(uint64_t number) const;

  std::vector<Step> steps_;  // by number - 1
  std::vector<Entry> entries_;
  std::map<std::string, Author> authors_;
  std::map<std::string, std::vector<uint64_t>> checkpoints_;  // all uses of each name
  std::unordered_set<std::string> ids_;
  uint64_t byte_count_ = 0;
};

/// Returns the bytes of an edit in memory as a part of a history. Accuracy: no less than it takes,
/// except for entries that undo and checkpoints switch.
uint64_t bytes_in_history(const AuthoredEdit& edit);

}  // namespace burnish
