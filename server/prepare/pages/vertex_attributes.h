#pragma once

#include <span>
#include <vector>

#include "common/base/scratch_vector.h"
#include "common/base/types.h"
#include "server/prepare/pages/page_vertices.h"
#include "server/prepare/pages/shared_vertices.h"

namespace burnish {

/// Values of a level's vertices besides their place, per vertex of the scan.
struct VertexAttributes {
  ScratchArray<Vec3f> normals;  ///< unit length
  ScratchArray<Rgba8> colours;  ///< empty, or one per vertex
};

/// A sum over the triangles at a vertex of a level, before it is divided by the weight.
struct AttributeSum {
  Vec3d normal = Vec3d::Zero();
  std::array<double, 4> colour = {};
  double weight = 0;
};

/// Sums of one page's triangles by vertex.
struct PageSums {
  std::vector<uint32_t> vertices;  ///< of the scan
  std::vector<AttributeSum> sums;  ///< as many
};

/// Takes the scan's own colours, and means its triangles' normals by their angles at each vertex.
/// A vertex whose triangles have no area or cancel out gets the normal +z.
/// `shared` is find_shared_vertices() of level 0. Throws: WorkCancelled.
VertexAttributes make_scan_attributes(const PagesInput& scan, const CutLevel& level,
                                      std::span<const uint8_t> shared, const ScratchSpace& space,
                                      const LoopPart& part);

/// Sums what one page of a level says of the next level's vertices, which are joined: the means of
/// its triangles' corners, weighted by area. So a coarse surface is shaded as the mean of the fine
/// one, and has its mean colour.
PageSums sum_page(const CutLevel& level, const VertexAttributes& attributes,
                  std::span<const Vec3i> positions, size_t page);

/// Adds up sums that several pages have of one vertex, and sets the attributes that they mean.
class AttributeSums {
 public:
  /// `shared` is find_shared_vertices() of the level.
  AttributeSums(std::span<const uint8_t> shared, std::span<const uint32_t> joined,
                const ScratchSpace& space)
      : shared_(shared), joined_(joined), space_(space), of_shared_(space) {}

  /// Sets the vertices that are this page's alone. Threads may call it for different pages.
  void set_own(const PageSums& sums, VertexAttributes& attributes) const;

  /// Keeps the sums of vertices of several pages. Call it in the order of pages.
  void keep_shared(const PageSums& sums);

  /// Sets the vertices of several pages. The order of pages decides how sums round. Throws:
  /// WorkCancelled.
  void set_shared(VertexAttributes& attributes, const LoopPart& part) const;

 private:
  struct SharedSum {
    uint32_t vertex;
    AttributeSum sum;
  };

  bool is_shared(uint32_t vertex) const { return shared_[joined_[vertex]] != 0; }

  std::span<const uint8_t> shared_;
  std::span<const uint32_t> joined_;
  ScratchSpace space_;
  ScratchVector<SharedSum> of_shared_;  ///< by page
};

}  // namespace burnish
