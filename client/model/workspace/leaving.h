#pragma once

#include <chrono>

#include "client/model/workspace/unsaved.h"

namespace burnish {

/// Leaves the open session, or the window, once all edits are saved and all files written. It gives
/// a server that answers a moment; if it takes longer, the user decides.
class Leaving {
 public:
  using Time = std::chrono::steady_clock::time_point;
  enum class What { kSession, kWindow };
  enum class Step {
    kStay,   ///< the user does not want to leave
    kSave,   ///< the server has a moment to save
    kAsk,    ///< the user chooses: wait(), discard() or stay()
    kWait,   ///< the user waits until all is saved
    kLeave,  ///< leave now
  };

  /// Begins to leave. A second call is harmless.
  void begin(What what, Time now);
  void wait() { is_waiting_ = true; }
  void discard() { is_discarding_ = true; }
  void stay() { *this = {}; }

  /// Returns the next step. Call once per picture. `is_live`: the server answers.
  Step update(const Unsaved& unsaved, bool is_live, Time now);
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
