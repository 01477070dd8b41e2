#include "common/gltf/scene.h"

#include <cmath>

#include <Eigen/SVD>

namespace burnish {

namespace {

/// Reads an array of numbers. Returns `absent` if the member is not there.
template <size_t kCount>
Result<std::array<double, kCount>> read_numbers(const GltfJson& node, const char* name,
                                                const std::string& place,
                                                const std::array<double, kCount>& absent) {
  const GltfJson* member = find_member(node, name);
  if (member == nullptr) return absent;
  std::array<double, kCount> numbers{};
  bool is_right = member->is_array() && member->size() == kCount;
  for (size_t i = 0; is_right && i < kCount; ++i) {
    is_right = (*member)[i].is_number();
    if (is_right) numbers[i] = (*member)[i].template get<double>();
    is_right = is_right && std::isfinite(numbers[i]);
  }
  if (is_right) return numbers;
  return invalid_argument(place + ": " + name + " is not " + std::to_string(kCount) +
                          " finite numbers");
}

Result<Eigen::Affine3d> read_matrix(const GltfJson& node, const std::string& place) {
  ASSIGN_OR_RETURN(const auto numbers, read_numbers<16>(node, "matrix", place, {}));
  Eigen::Affine3d transform;
  transform.matrix() = Eigen::Map<const Eigen::Matrix4d>(numbers.data());
  if (transform.matrix().row(3) == Eigen::RowVector4d(0, 0, 0, 1)) return transform;
  return invalid_argument(place + ": the last row of its matrix is not 0 0 0 1");
}

Result<Eigen::Affine3d> read_transform(const GltfJson& node, const std::string& place) {
  if (find_member(node, "matrix") != nullptr) return read_matrix(node, place);
  ASSIGN_OR_RETURN(const auto t, read_numbers<3>(node, "translation", place, {0, 0, 0}));
  ASSIGN_OR_RETURN(const auto r, read_numbers<4>(node, "rotation", place, {0, 0, 0, 1}));
  ASSIGN_OR_RETURN(const auto s, read_numbers<3>(node, "scale", place, {1, 1, 1}));
  const Eigen::Quaterniond rotation(r[3], r[0], r[1], r[2]);
  if (!(rotation.norm() > 0))
    return invalid_argument(place + ": its rotation is a quaternion of length 0");
  Eigen::Affine3d transform = Eigen::Affine3d::Identity();
  transform.translate(Eigen::Vector3d(t[0], t[1], t[2]));
  transform.rotate(rotation.normalized());
  transform.scale(Eigen::Vector3d(s[0], s[1], s[2]));
  return transform;
}

bool can_be_inverted(const Eigen::Affine3d& transform) {
  constexpr double kSmallest = 1e-12;  // of the ratio between two directions' scales
  if (!transform.matrix().allFinite()) return false;
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(transform.linear());
  const double largest = svd.singularValues()[0];
  return std::isnormal(largest) && svd.singularValues()[2] > kSmallest * largest &&
         transform.inverse().matrix().allFinite();
}

/// Walks the nodes without recursion: a hostile file could fill the stack.
class SceneWalk {
 public:
  explicit SceneWalk(const GltfDocument& document)
      : json_(document.json), is_reached_(count_elements(document.json, "nodes")) {}

  Result<std::vector<GltfPlacement>> walk() {
    RETURN_IF_ERROR(push_roots());
    while (!open_.empty()) {
      const Open node = open_.back();
      open_.pop_back();
      RETURN_IF_ERROR(visit(node));
    }
    return std::move(placements_);
  }

 private:
  struct Open {
    uint64_t node = 0;
    Eigen::Affine3d parent = Eigen::Affine3d::Identity();
  };

  Status push_roots() {
    const size_t scenes = count_elements(json_, "scenes");
    if (scenes == 0) return push_orphans();
    ASSIGN_OR_RETURN(const uint64_t scene, read_whole(json_, "scene", "the file", 0));
    ASSIGN_OR_RETURN(const GltfJson* json, find_element(json_, "scenes", scene, "the file"));
    return push_all(*json, "nodes", place_text("scene", scene), Eigen::Affine3d::Identity());
  }

  Status push_orphans() {
    std::vector<bool> is_child(is_reached_.size());
    for (uint64_t n = 0; n < is_child.size(); ++n) {
      const GltfJson* children = find_member(json_.at("nodes")[n], "children");
      if (children == nullptr || !children->is_array()) continue;
      for (const GltfJson& child : *children)
        if (child.is_number_unsigned() && child.get<uint64_t>() < is_child.size())
          is_child[child.get<uint64_t>()] = true;
    }
    for (uint64_t n = is_child.size(); n-- > 0;)
      if (!is_child[n]) open_.push_back({n});
    return Status::ok();
  }

  /// Pushes the nodes of a list, the first on top.
  Status push_all(const GltfJson& json, const char* name, const std::string& place,
                  const Eigen::Affine3d& parent) {
    const GltfJson* nodes = find_member(json, name);
    if (nodes == nullptr || !nodes->is_array()) return Status::ok();
    for (size_t i = nodes->size(); i-- > 0;) {
      const GltfJson& node = (*nodes)[i];
      if (!node.is_number_unsigned())
        return invalid_argument(place + ": " + value_text(node) + " is not the number of a node");
      open_.push_back({node.get<uint64_t>(), parent});
    }
    return Status::ok();
  }

  Status visit(const Open& open) {
    const std::string place = place_text("node", open.node);
    ASSIGN_OR_RETURN(const GltfJson* json, find_element(json_, "nodes", open.node, "the scene"));
    if (is_reached_[open.node])
      return invalid_argument(place + " is reached twice; nodes must be a tree");
    is_reached_[open.node] = true;
    ASSIGN_OR_RETURN(const Eigen::Affine3d own, read_transform(*json, place));
    const Eigen::Affine3d to_scene(open.parent * own);
    if (find_member(*json, "mesh") != nullptr)
      RETURN_IF_ERROR(place_mesh(*json, open.node, to_scene, place));
    return push_all(*json, "children", place, to_scene);
  }

  Status place_mesh(const GltfJson& json, uint64_t node, const Eigen::Affine3d& to_scene,
                    const std::string& place) {
    ASSIGN_OR_RETURN(const uint64_t mesh, read_whole(json, "mesh", place));
    RETURN_IF_ERROR(find_element(json_, "meshes", mesh, place).status());
    if (find_member(json, "skin") != nullptr)
      return invalid_argument(place + " has a skin, which Burnish cannot edit; apply its pose");
    if (!can_be_inverted(to_scene))
      return invalid_argument(place + ": its transform flattens the mesh, or is not finite");
    const bool is_identity = to_scene.matrix() == Eigen::Matrix4d::Identity();
    placements_.push_back({node, mesh, to_scene, is_identity});
    return Status::ok();
  }

  const GltfJson& json_;
  std::vector<bool> is_reached_;
  std::vector<Open> open_;
  std::vector<GltfPlacement> placements_;
};

}  // namespace

Result<std::vector<GltfPlacement>> place_meshes(const GltfDocument& document) {
  return SceneWalk(document).walk();
}

}  // namespace burnish
