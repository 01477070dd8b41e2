#pragma once

#include "common/base/progress.h"

namespace burnish {

/// While it lives, Ctrl+C and SIGTERM do not end the program but cancel its work: what was half
/// made is removed on the way out. A second one ends it. One at a time.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  /// Returns a Progress that goes on to `next` until it cancels.
  static Progress cancelling(Progress next);
};

}  // namespace burnish
