#pragma once

#include <map>
#include <memory>
#include <optional>
#include <tuple>
#include <vector>

#include "common/base/progress.h"
#include "common/frame_codec/frame_layout.h"
#include "server/library/mesh_cache.h"
#include "server/memory/quota.h"
#include "server/scheduling/fair_mutex.h"

namespace burnish {

/// The mesh that a client draws, which its frames describe. Clients with the same mesh share it.
struct FrameTarget {
  std::shared_ptr<const SharedMesh> mesh;
  std::vector<EvaluationPoint> proxy_points;  ///< empty for the whole scan
  std::shared_ptr<const FrameLayout> layout;
  Quota::Share memory;  ///< share of the server's memory

  FrameMesh frame_mesh() const;
};

/// The targets in use. Clients own them together; this only finds them again. Thread-safe.
class FrameTargets {
 public:
  /// Needs: `memory` outlives it.
  explicit FrameTargets(Quota& memory) : memory_(memory) {}

  /// Takes the whole scan if triangles_max is 0 or the scan has no more, else a proxy: as FetchView
  /// does. Without a content it takes the one whose frames are likely smaller. Cost of the first
  /// use: see make_proxy() and the layouts. Fails: cancelled; resource_exhausted if the memory has
  /// no room for it.
  Result<std::shared_ptr<const FrameTarget>> find_or_make(
      const std::shared_ptr<const SharedMesh>& mesh, uint64_t triangles_max,
      std::optional<FrameContent> content, const Progress& progress);

 private:
  using Key = std::tuple<const SharedMesh*, uint64_t, std::optional<FrameContent>>;

  Quota& memory_;
  FairMutex mutex_;  // also held while a target is made: the next client may want the same
  std::map<Key, std::weak_ptr<const FrameTarget>> targets_;
};

}  // namespace burnish
