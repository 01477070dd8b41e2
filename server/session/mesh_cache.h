#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "common/service/scan_info.h"
#include "server/metrics/live_objects.h"
#include "server/prepare/prepared_mesh.h"
#include "server/session/quota.h"
#include "server/solver/hierarchy.h"

namespace burnish {

/// What all sessions of one prepared mesh share.
struct SharedMesh {
  std::shared_ptr<const PreparedMesh> prepared;
  std::shared_ptr<const Hierarchy> hierarchy;
  Quota::Share memory;
  LiveObject live{LiveKind::kMesh};

  uint64_t byte_count() const {  ///< needs a hierarchy
    return prepared->byte_count() + hierarchy->byte_count();
  }
};

/// The shared meshes in memory. Sessions own them together; the cache only finds them again.
/// Thread-safe.
class MeshCache {
 public:
  using Key = std::pair<std::string, PreparedKey>;  ///< scan id, which prepared mesh

  /// The mesh if somebody holds it, else null.
  std::shared_ptr<const SharedMesh> find(const Key& key);

  void add(const Key& key, const std::shared_ptr<const SharedMesh>& mesh);

  /// Of the meshes that somebody holds.
  uint64_t byte_count() const;

 private:
  mutable std::mutex mutex_;
  std::map<Key, std::weak_ptr<const SharedMesh>> meshes_;
};

}  // namespace burnish
