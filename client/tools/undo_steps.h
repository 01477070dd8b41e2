#pragma once

#include <vector>

namespace burnish {

/// How many edits each step of the user made, so that undo takes back a whole step: a preset, or a
/// stroke and its mirror image. Steps that are not known here have one edit.
class UndoSteps {
 public:
  /// An edit was made. Nothing is left to redo.
  void add() {
    done_.push_back(1);
    undone_.clear();
  }
  /// The last two edits are one step.
  void join_last_two() {
    if (done_.size() < 2) return;
    const int edits = done_.back();
    done_.pop_back();
    done_.back() += edits;
  }
  /// Forgets all steps: somebody has switched entries of the history.
  void clear() {
    done_.clear();
    undone_.clear();
  }

  /// Return how many edits to undo or redo, 1 at least.
  int undo() { return move_last(done_, undone_); }
  int redo() { return move_last(undone_, done_); }

 private:
  static int move_last(std::vector<int>& from, std::vector<int>& to) {
    const int edits = from.empty() ? 1 : from.back();
    if (!from.empty()) from.pop_back();
    to.push_back(edits);
    return edits;
  }

  std::vector<int> done_;
  std::vector<int> undone_;
};

}  // namespace burnish
