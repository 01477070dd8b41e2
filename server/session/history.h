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

/// What the edits of a session amount to: the list of its entries, each on or off. An entry is an
/// edit that makes fields, or a checkpoint; undo, redo, switches and restored checkpoints only
/// change which entries are on. The same edits in the same order give the same history.
///
/// A damaged edit is an entry that is never on. Undo, redo and switches of before it was damaged
/// count it as though it were good, so that they go on to mean the entries that they meant.
class History {
 public:
  struct Entry {
    uint64_t number;  ///< of the edit that made it, counted from 1 over all edits of the session
    std::shared_ptr<const AuthoredEdit> made_by;
    bool enabled = true;       ///< also of a damaged one: whether undo would switch it off
    uint64_t stroke_hash = 0;  ///< of a stroke's content, see paint_checkpoints.h

    bool is_damaged() const { return kind_of(made_by->edit) == EditKind::kDamaged; }
    bool is_on() const { return enabled && !is_damaged(); }
  };

  /// Edits so far; the next one's number is one more.
  uint64_t size() const { return steps_.size(); }

  bool knows(const std::string& author, const std::string& edit_id) const;

  /// Returns the number of the entry that the edit made or switched, 0 for a restored checkpoint.
  /// Needs: an id that the author has not used. A failed edit changes nothing.
  /// Fails: failed_precondition (nothing to undo or redo), not_found (no such entry or checkpoint),
  /// invalid_argument (a checkpoint cannot be switched, nor a damaged entry be switched on).
  Result<uint64_t> apply(AuthoredEdit edit);

  /// Takes an edit that a history has had before. Returns false when it has no effect any more,
  /// because it is damaged or needs one that is; its number is taken all the same.
  bool restore(AuthoredEdit edit);

  /// Forgets the last edit as though it had never been.
  void take_back();

  /// What the edits take in memory, see bytes_in_history().
  uint64_t byte_count() const { return byte_count_; }

  /// By number.
  const std::vector<Entry>& entries() const { return entries_; }

  /// The number of the edit that last gave a checkpoint this name. Fails: not_found.
  Result<uint64_t> checkpoint(const std::string& name) const;

 private:
  /// One applied edit and what to do to forget it.
  struct Step {
    std::shared_ptr<const AuthoredEdit> edit;
    std::vector<uint64_t> switched;  // entries
    std::vector<uint64_t> not_redoable;
  };
  struct Author {
    std::set<uint64_t> enabled;    // entries that make fields
    std::vector<uint64_t> undone;  // entries, the last undone last
  };

  Result<uint64_t> enter(Step step);
  Status check_switch(const Edit& edit) const;

  // Each returns what apply() does.
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
  std::map<std::string, std::vector<uint64_t>> checkpoints_;  // every use of the name
  std::unordered_set<std::string> ids_;
  uint64_t byte_count_ = 0;
};

/// What an edit takes in memory as a part of a history.
/// Accuracy: no less than it takes, but for what undo and checkpoints switch.
uint64_t bytes_in_history(const AuthoredEdit& edit);

}  // namespace burnish
