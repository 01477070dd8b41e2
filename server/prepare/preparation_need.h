#pragma once

#include <cstdint>
#include <string>

#include "common/base/status.h"

namespace burnish {

/// What a preparation has counted so far; what it has not is zero.
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

/// What a preparation takes, as far as it can be told from its counts.
struct PreparationNeed {
  PreparationCounts counts;
  uint64_t memory_bytes = 0;  ///< at its peak, with the scan itself
  uint64_t file_bytes = 0;    ///< of the prepared file; 0: not known yet
};

/// Accuracy: with all counts, no less than the peak of resident memory, and at most half as much
/// again; the file to the byte but for alignment.
PreparationNeed predict_preparation(const PreparationCounts& counts);

/// "preparing 2 triangles at depth 11 takes 3100 MiB of memory and a file of 2900 MiB (4003002
/// cells)".
std::string to_string(const PreparationNeed& need);

/// Where a preparation has its memory and its disk from.
class PreparationBudget {
 public:
  virtual ~PreparationBudget() = default;

  /// Bytes of memory beyond which ask() fails in any case: counting ends there.
  virtual uint64_t memory_bytes_max() const = 0;

  /// Called before anything is taken, and again whenever more is known; each call counts for all.
  /// Fails: resource_exhausted with what is short and its limit.
  virtual Status ask(const PreparationNeed& need) = 0;
};

/// The memory that this machine can give without swapping at the time when this is made.
class MachineBudget : public PreparationBudget {
 public:
  MachineBudget();
  uint64_t memory_bytes_max() const override { return bytes_max_; }
  Status ask(const PreparationNeed& need) override;

 private:
  const uint64_t bytes_max_;
};

}  // namespace burnish
