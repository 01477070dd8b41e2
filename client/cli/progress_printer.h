#pragma once

#include <chrono>
#include <string>

#include "common/base/progress.h"

namespace burnish {

/// How progress is told.
enum class ProgressStyle {
  kText,  ///< a bar on a terminal, else a line per phase
  kJson,  ///< lines {"phase": NAME, "fraction": 0 to 1}, at most ten a second and phase
};

/// Shows the progress of long work on standard error.
class ProgressPrinter {
 public:
  explicit ProgressPrinter(ProgressStyle style = ProgressStyle::kText);
  /// Ends the bar's line.
  ~ProgressPrinter();
  ProgressPrinter(const ProgressPrinter&) = delete;
  ProgressPrinter& operator=(const ProgressPrinter&) = delete;

  /// Returns a Progress that never cancels. Needs: the printer outlives it.
  Progress progress();

 private:
  void show(std::string_view phase, double fraction);
  void draw_bar(double fraction);
  void print_line(double fraction);

  const ProgressStyle style_;
  const bool terminal_;
  std::string phase_;
  std::chrono::steady_clock::time_point drawn_;
};

}  // namespace burnish
