#pragma once

#include <atomic>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "common/service/scan_info.h"
#include "server/memory/quota.h"
#include "server/metrics/live_objects.h"
#include "server/scheduling/fair_mutexes.h"
#include "server/solver/cycle/multigrid.h"

namespace burnish {

/// The data that all sessions of one prepared mesh share.
struct SharedMesh : Multigrid {
  Quota::Share memory;
  uint64_t fingerprint = 0;  ///< of the file that its hierarchy may be kept in
  /// The file has it, or will, or cannot.
  mutable std::atomic<bool> is_kept = false;
  LiveObject live{LiveKind::kMesh};
};

/// The shared meshes in memory. Sessions own them together; the cache only finds them again.
/// Thread-safe.
class MeshCache {
 public:
  using Key = std::pair<std::string, PreparedKey>;  ///< scan id and prepared mesh

  /// Returns the mesh if somebody holds it, else null.
  std::shared_ptr<const SharedMesh> find(const Key& key);

  void add(const Key& key, const std::shared_ptr<const SharedMesh>& mesh);

  /// Returns the mutex to hold while making the mesh, so that others wait for it.
  std::shared_ptr<FairMutex> making(const Key& key) { return making_.of(key); }

  /// Returns the bytes of the meshes that somebody holds.
  uint64_t byte_count() const;

 private:
  mutable std::mutex mutex_;
  std::map<Key, std::weak_ptr<const SharedMesh>> meshes_;
  FairMutexes<Key> making_;
};

}  // namespace burnish
