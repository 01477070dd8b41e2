#pragma once

#include <chrono>
#include <string>

#include "common/base/progress.h"

namespace burnish {

/// Shows the progress of long work on standard error: a bar on a terminal, else a line per phase.
class ProgressPrinter {
 public:
  ProgressPrinter();
  /// Ends the bar's line.
  ~ProgressPrinter();
  ProgressPrinter(const ProgressPrinter&) = delete;
  ProgressPrinter& operator=(const ProgressPrinter&) = delete;

  /// Returns a Progress that never cancels. Needs: the printer outlives it.
  Progress progress();

 private:
  void show(std::string_view phase, double fraction);
  void draw_bar(double fraction);

  const bool terminal_;
  std::string phase_;
  std::chrono::steady_clock::time_point drawn_;
};

}  // namespace burnish
