#pragma once

#include <chrono>
#include <string>

#include "common/base/process_memory.h"
#include "server/prepare/prepared_mesh.h"

namespace burnish {

/// Times the phases of a preparation.
class PhaseClock {
 public:
  /// `report` may be null.
  explicit PhaseClock(PrepareReport* report) : report_(report) { reset_peak_resident_bytes(); }

  /// Ends a phase; the next one begins.
  void end(const std::string& name) {
    const auto now = std::chrono::steady_clock::now();
    if (report_ != nullptr)
      report_->phases.push_back(
          {name, std::chrono::duration<double>(now - start_).count(), peak_resident_bytes()});
    start_ = now;
    reset_peak_resident_bytes();
  }

 private:
  PrepareReport* report_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace burnish
