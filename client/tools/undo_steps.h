#pragma once

#include <string>
#include <utility>
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

  /// Return how many edits to undo or redo, 1 at least. `name`: of the step, for redo_name().
  int undo(std::string name = {}) {
    const int edits = next_undo();
    if (!done_.empty()) done_.pop_back();
    undone_.push_back({edits, std::move(name)});
    return edits;
  }
  int redo() {
    const int edits = undone_.empty() ? 1 : undone_.back().edits;
    if (!undone_.empty()) undone_.pop_back();
    done_.push_back(edits);
    return edits;
  }

  int next_undo() const { return done_.empty() ? 1 : done_.back(); }
  /// Returns the name of the step that redo() makes again; empty: it is not known.
  std::string redo_name() const { return undone_.empty() ? std::string() : undone_.back().name; }

 private:
  struct Undone {
    int edits;
    std::string name;
  };

  std::vector<int> done_;
  std::vector<Undone> undone_;
};

}  // namespace burnish
