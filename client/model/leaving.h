#pragma once

#include <chrono>
#include <cstddef>

namespace burnish {

/// Leaves the open session, or the window with it, once all edits are saved. A server that answers
/// is given a moment; what takes longer is for the user to decide.
class Leaving {
 public:
  using Time = std::chrono::steady_clock::time_point;
  enum class What { kSession, kWindow };
  enum class Step {
    kStay,   ///< nobody wants to leave
    kSave,   ///< the moment that is given
    kAsk,    ///< wait(), discard() or stay()?
    kWait,   ///< until all is saved, as the user wants
    kLeave,  ///< now
  };

  /// Somebody wants to leave. Harmless when it is said again.
  void begin(What what, Time now);
  void wait() { is_waiting_ = true; }
  void discard() { is_discarding_ = true; }
  void stay() { *this = {}; }

  /// Once per picture. `is_live`: the server answers.
  Step update(size_t unsaved_edits, bool is_live, Time now);
  What what() const { return what_; }

 private:
  What what_ = What::kSession;
  bool has_begun_ = false;
  Time begun_;
  bool is_asking_ = false;
  bool is_waiting_ = false;
  bool is_discarding_ = false;
};

}  // namespace burnish
