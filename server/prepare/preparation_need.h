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
  bool has_joins = false;    ///< several vertices are at one place
  bool copies_mesh = false;  ///< the caller keeps the scan that is copied
  uint64_t pieces = 0;       ///< pairs of a cell and a triangle
  uint64_t cells = 0;        ///< of the finest depth
  uint64_t sheets = 0;
};

/// The need of a preparation, as far as its counts tell.
struct PreparationNeed {
  PreparationCounts counts;
  uint64_t memory_bytes = 0;   ///< at its peak, including the scan; without mapped files
  uint64_t scratch_bytes = 0;  ///< of files for arrays beyond the memory, at their peak
  uint64_t file_bytes = 0;     ///< of the prepared file; 0: unknown
};

/// `arrays_bytes_max` is ScratchSpace::memory_bytes_max(): more arrays than that lie in files.
/// Accuracy: with all counts, no less than the peak of anonymous memory, and at most half as much
/// again. The file is exact except for alignment.
PreparationNeed predict_preparation(const PreparationCounts& counts,
                                    uint64_t arrays_bytes_max = UINT64_MAX);

/// "preparing 2 triangles at depth 11 takes 3100 MiB of memory and a file of 2900 MiB (4003002
/// cells)".
std::string to_string(const PreparationNeed& need);

/// Admits a preparation to memory and disk.
class PreparationBudget {
 public:
  virtual ~PreparationBudget() = default;

  /// Returns the bytes of memory beyond which ask() always fails: counting ends there.
  virtual uint64_t memory_bytes_max() const = 0;

  /// Returns the same for bytes of scratch files.
  virtual uint64_t scratch_bytes_max() const { return 0; }

  /// Returns the bytes of a prepared scan with one session that the default depth may take.
  virtual uint64_t default_depth_bytes_max() const { return UINT64_MAX; }

  /// Called before anything is taken, and again when more is known; each call counts for all.
  /// Fails: resource_exhausted with the missing amount and its limit.
  virtual Status ask(const PreparationNeed& need) = 0;
};

/// The memory that the machine could give without swapping when this was made.
class MachineBudget : public PreparationBudget {
 public:
  MachineBudget();
  uint64_t memory_bytes_max() const override { return bytes_max_; }
  uint64_t default_depth_bytes_max() const override;  ///< depends on the machine, not on its load
  Status ask(const PreparationNeed& need) override;

 private:
  const uint64_t bytes_max_;
};

}  // namespace burnish
