#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Geometry>

#include "common/base/status.h"
#include "common/gltf/document.h"

namespace burnish {

/// A mesh that a node of the scene places.
struct GltfPlacement {
  uint64_t node = 0;
  uint64_t mesh = 0;
  Eigen::Affine3d to_scene = Eigen::Affine3d::Identity();  ///< can be inverted
  bool is_identity = true;
};

/// Returns the meshes of the document's scene, in the order of a walk from its roots: of its
/// default scene, else its first, else all nodes that are nobody's child. Fails: invalid_argument
/// for a node that is reached twice, a transform that is not affine or cannot be inverted, and a
/// mesh with a skin.
Result<std::vector<GltfPlacement>> place_meshes(const GltfDocument& document);

}  // namespace burnish
