#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "server/session/edited_fields.h"

namespace burnish {

/// A user's drag that has not ended: the edit that it would be if it ended now.
struct Gesture {
  std::string author;
  std::string edit_id;
  PreviewChange change;
};

/// The effect of running gestures on the fields of a session. It is shown and kept nowhere:
/// gestures work on a copy, and the edited fields never see them. The last moved slider or curve
/// counts; strokes are painted in the order in which they began.
class Previews {
 public:
  /// Begins a connection's gesture, or continues it if the id is the same. A continued stroke keeps
  /// the path so far as the beginning of the new one.
  void show(uint64_t connection, Gesture gesture);

  /// Does nothing for a connection without a gesture.
  void drop(uint64_t connection);

  void clear();

  /// Drops the gestures whose edits the history has.
  void drop_applied(const History& history);

  bool empty() const { return shown_.empty(); }

  /// Returns whether over() would give a different result than last time for the same edited
  /// fields.
  bool is_changed() const { return changes_.any(); }

  /// Returns the edited fields with the gestures on top, valid until the next call. Needs:
  /// `changes` says what has changed in the edited fields. Adds the changes by gestures.
  const Fields& over(const Fields& edited, EditEffects& changes);

  /// Returns the result of the last over(). Needs: the same edited fields.
  const Fields& shown(const Fields& edited) const { return copy_ ? *copy_ : edited; }

  /// For a solve without gestures: returns the changes that leave them out. The next over() brings
  /// them back.
  EditEffects set_aside();

  uint64_t byte_count() const { return copy_ ? copy_->byte_count() : 0; }

 private:
  struct Shown {
    uint64_t connection;
    Gesture gesture;
    size_t painted_dabs = 0;  ///< dabs of a stroke that the copy has
  };

  void apply(Shown& shown);
  void set_counting(Settings settings);

  std::vector<Shown> shown_;
  std::optional<Fields> copy_;  // with all shown gestures
  bool copy_is_old_ = false;
  EditEffects changes_;  // since the last over()
};

}  // namespace burnish
