#pragma once

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "common/base/status.h"
#include "server/solver/cuda/device/views.h"
#include "server/solver/cycle/halo_lists.h"
#include "server/solver/hierarchy/hierarchy.h"

namespace burnish::cuda {

class Stream;

/// The lists of one shard. All of them must outlive its halo's making.
struct ShardLists {
  int device;
  const Hierarchy* hierarchy;
  std::span<const HaloLists> depths;  ///< from the border depth on
  const BorderLists* border;
};

/// Parts that all shards of a scan share.
struct ShardGroup {
  int border;
  bool has_patches;
  /// Waits until every shard has arrived, then does the work once (multi/lock_step.h).
  std::function<void(const std::function<void()>&)> arrive_and_wait;
};

/// Asks the other shards, on a device: see cpu/halo.h. An owner puts its numbers into
/// memory that the others' devices read; each of them waits for that on its own stream. Two such
/// places take turns, so that nobody overwrites what another still reads.
///
/// Several devices record one graph: its edges order their work. No kernel waits for another, so
/// all shards may be on one device too.
class Halo {
 public:
  virtual ~Halo() = default;
  virtual int border() const = 0;
  virtual bool is_first() const = 0;  ///< has the border depth and those above
  virtual bool has_patches() const = 0;

  virtual void refresh(Stream& stream, int depth, float4* vector) = 0;
  virtual void refresh(Stream& stream, int depth, float* vector) = 0;
  virtual void add_up(Stream& stream, int depth, float4* vector) = 0;
  virtual void collect(Stream& stream, double* numbers) = 0;

  /// Returns where all shards' totals stand for the next kernel of the stream, which must start
  /// with launch_whole(). Uses of one `slot` must come one after the other. Shapes: `mine` has
  /// OfShards::kTotals numbers.
  virtual OfShards share(Stream& stream, int slot, const double* mine) = 0;
  virtual int slot_of_solver() const = 0;  ///< other slots are depths
  virtual void keep_largest(Stream& stream, float* number) = 0;

  /// Returns whether all shards ask with true.
  virtual bool all(bool here) = 0;
  /// Says that a graph cannot have the cycle: part of it is the host's work.
  virtual void never_record() = 0;
  /// Does `work`, or what it did before: see Graphs::run().
  virtual void run_recorded(int key, Stream& stream, const std::function<void()>& work) = 0;
};

/// Makes the halos of all shards. Fails: failed_precondition if a device cannot read another's
/// memory; resource_exhausted, internal.
Result<std::vector<std::unique_ptr<Halo>>> make_halos(const ShardGroup& group,
                                                      std::span<const ShardLists> shards);

}  // namespace burnish::cuda
