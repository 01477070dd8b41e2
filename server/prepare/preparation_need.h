#pragma once

#include <cstdint>
#include <string>

#include "common/base/status.h"

namespace burnish {

/// The counts of a preparation so far; 0 for those not yet known.
struct PreparationCounts {
  int depth = 0;
  uint64_t vertices = 0;
  uint64_t triangles = 0;
  bool has_colours = false;
  bool has_several_components = false;
  uint64_t pieces = 0;  ///< pairs of a cell and a triangle
  uint64_t cells = 0;   ///< of the finest depth
  uint64_t sheets = 0;
};

/// The need of a preparation, as far as its counts tell.
struct PreparationNeed {
  PreparationCounts counts;
  uint64_t memory_bytes = 0;  ///< at its peak, including the scan
  uint64_t file_bytes = 0;    ///< of the prepared file; 0: unknown
};

/// Accuracy: with all counts, no less than the peak of resident memory, and at most half as much
/// again. The file is exact except for alignment.
PreparationNeed predict_preparation(const PreparationCounts& counts);

/// "preparing 2 triangles at depth 11 takes 3100 MiB of memory and a file of 2900 MiB (4003002
/// cells)".
std::string to_string(const PreparationNeed& need);

/// Admits a preparation to memory and disk.
class PreparationBudget {
 public:
  virtual ~PreparationBudget() = default;

  /// Returns the bytes of memory beyond which ask() always fails: counting ends there.
  virtual uint64_t memory_bytes_max() const = 0;

  /// Called before anything is taken, and again when more is known; each call counts for all.
  /// Fails: resource_exhausted with the missing amount and its limit.
  virtual Status ask(const PreparationNeed& need) = 0;
};

/// The memory that the machine could give without swapping when this was made.
class MachineBudget : public PreparationBudget {
 public:
  MachineBudget();
  uint64_t memory_bytes_max() const override { return bytes_max_; }
  Status ask(const PreparationNeed& need) override;

 private:
  const uint64_t bytes_max_;
};

}  // namespace burnish
