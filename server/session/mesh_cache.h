#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "common/base/status.h"
#include "common/service/scan_info.h"
#include "server/prepare/prepared_mesh.h"
#include "server/solver/hierarchy.h"

namespace burnish {

/// What all sessions of one prepared mesh share.
struct SharedMesh {
  std::shared_ptr<const PreparedMesh> prepared;
  std::shared_ptr<const Hierarchy> hierarchy;

  uint64_t byte_count() const { return prepared->byte_count() + hierarchy->byte_count(); }
};

/// The shared meshes in memory. Sessions own them together; the cache only finds them again and
/// counts their bytes against a budget. Thread-safe.
class MeshCache {
 public:
  using Key = std::pair<std::string, PreparedKey>;  ///< scan id, which prepared mesh

  explicit MeshCache(uint64_t bytes_max) : bytes_max_(bytes_max) {}

  /// The mesh if somebody holds it, else null.
  std::shared_ptr<const SharedMesh> find(const Key& key);

  /// Fails: resource_exhausted with the numbers when the budget has no room for the mesh.
  Status admit(const Key& key, const std::shared_ptr<const SharedMesh>& mesh);

 private:
  const uint64_t bytes_max_;
  std::mutex mutex_;
  std::map<Key, std::weak_ptr<const SharedMesh>> meshes_;
};

}  // namespace burnish
