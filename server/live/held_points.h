#pragma once

#include <map>
#include <memory>
#include <vector>

#include "common/page_frames/held_vertices.h"
#include "server/fields/rims.h"
#include "server/live/live_page.h"
#include "server/prepare/prepared_mesh.h"

namespace burnish {

/// Finds the vertices of pages that lie on the held rims of a session. An export puts these
/// vertices back, so frames do too. Not thread-safe.
class HeldPoints {
 public:
  HeldPoints(const PreparedMesh& prepared, std::shared_ptr<const HeldRims> rims);

  const std::shared_ptr<const HeldRims>& rims() const { return rims_; }

  /// Finds them once for each page, as long as somebody shows it. Needs: a page of the scan.
  HeldVertices of(const std::shared_ptr<const LivePage>& page);

 private:
  struct Found {
    std::weak_ptr<const LivePage> page;
    HeldVertices held;
  };
  void place_on(const PageGrid& lattice);
  HeldVertices find(const LivePage& page) const;

  const std::shared_ptr<const HeldRims> rims_;
  std::vector<Vec3d> points_;  // of the rims, file units
  PageGrid lattice_;           // of places_
  std::vector<Vec3i> places_;  // where pages may have the points, sorted
  std::map<const LivePage*, Found> found_;
};

}  // namespace burnish
