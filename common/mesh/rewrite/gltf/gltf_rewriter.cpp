#include "common/mesh/rewrite/gltf/gltf_rewriter.h"

#include <algorithm>
#include <map>
#include <string_view>

#include "common/mesh/rewrite/gltf/gltf_accessors.h"
#include "common/mesh/rewrite/gltf/gltf_images.h"

namespace burnish {

namespace {

/// The accessors of a mesh's parts as one node wants them.
struct GltfWish {
  uint64_t primitive = 0;
  uint64_t positions = 0;
  uint64_t normals = kNoAccessor;
  bool is_unpacked = false;  // its Draco data go
  auto operator<=>(const GltfWish&) const = default;
};
using GltfWishes = std::vector<GltfWish>;

class GltfRewriter {
 public:
  GltfRewriter(const GltfSurface& surface, const GltfColumns& columns, GltfEdit& edit)
      : surface_(surface), columns_(columns), edit_(edit), accessors_(columns, edit) {}

  void rewrite() {
    accessors_.put_columns();
    for (size_t p = 0; p < surface_.parts.size(); ++p) unpack_if_changed(p);
    std::map<size_t, GltfWishes> wishes;  // by placement
    for (size_t p = 0; p < surface_.parts.size(); ++p)
      wishes[surface_.parts[p].placement].push_back(wish_of(p));
    for (const auto& [placement, wished] : wishes) grant(surface_.placements[placement], wished);
    drop_unused_draco();
  }

 private:
  bool is_changed(size_t part) const {
    const std::optional<size_t> normals = columns_.normals[part];
    return columns_.all[columns_.positions[part]].is_changed ||
           (normals && columns_.all[*normals].is_changed);
  }

  /// Writes the attributes of a Draco primitive that stay, and its indices.
  void unpack_if_changed(size_t part) {
    const GltfPrimitive& primitive = *surface_.parts[part].primitive;
    if (!primitive.is_draco || !is_changed(part)) return;
    for (const auto& [name, accessor] : primitive.attributes) {
      const bool is_column = name == "POSITION" || name == "NORMAL";
      const size_t column =
          name == "POSITION" ? columns_.positions[part] : columns_.normals[part].value_or(0);
      if (!is_column || !columns_.all[column].is_changed) accessors_.put_unpacked(accessor, true);
    }
    const auto [found, is_new] = indices_.try_emplace(&primitive);
    if (is_new) found->second = accessors_.put_unpacked(*primitive.indices, false);
  }

  GltfWish wish_of(size_t part) const {
    const GltfPrimitive& primitive = *surface_.parts[part].primitive;
    GltfWish wish{primitive.number, accessors_.accessor_of(columns_.positions[part])};
    if (columns_.normals[part]) wish.normals = accessors_.accessor_of(*columns_.normals[part]);
    wish.is_unpacked = primitive.is_draco && is_changed(part);
    return wish;
  }

  /// Lets a node place a mesh of its wish: its own, if it is the first to ask, else a copy.
  void grant(const GltfPlacement& placed, const GltfWishes& wishes) {
    auto& granted = granted_[placed.mesh];
    const auto [found, is_new] = granted.try_emplace(wishes, placed.mesh);
    GltfJson& meshes = edit_.json()["meshes"];
    if (is_new && granted.size() > 1) {
      found->second = meshes.size();
      meshes.push_back(GltfJson(edit_.document().json.at("meshes")[placed.mesh]));
    }
    if (is_new)
      for (const GltfWish& wish : wishes)
        apply(wish, placed.mesh, meshes[found->second]["primitives"][wish.primitive]);
    if (found->second != placed.mesh) edit_.json()["nodes"][placed.node]["mesh"] = found->second;
  }

  void apply(const GltfWish& wish, uint64_t mesh, GltfJson& primitive) {
    const auto put = [](GltfJson& object, const char* name, uint64_t value) {
      if (object[name] != value) object[name] = value;
    };
    put(primitive["attributes"], "POSITION", wish.positions);
    if (wish.normals != kNoAccessor) put(primitive["attributes"], "NORMAL", wish.normals);
    if (!wish.is_unpacked) return;
    put(primitive, "indices", indices_.at(&*surface_.primitives.at({mesh, wish.primitive})));
    if (primitive.contains("mode")) put(primitive, "mode", uint64_t{4});
    primitive["extensions"].erase(kDracoExtension);
    if (primitive["extensions"].empty()) primitive.erase("extensions");
  }

  /// Takes Draco out of the lists of extensions if no primitive has it any more.
  void drop_unused_draco() {
    const GltfJson& json = edit_.json();
    if (indices_.empty()) return;
    for (const GltfJson& mesh : json.at("meshes")) {
      const GltfJson* primitives = find_member(mesh, "primitives");
      if (primitives == nullptr) continue;
      for (const GltfJson& primitive : *primitives)
        if (find_object(primitive, {"extensions", kDracoExtension}) != nullptr) return;
    }
    for (const char* list : {"extensionsUsed", "extensionsRequired"}) erase_from(list);
  }

  void erase_from(const char* list) {
    if (!edit_.json().contains(list) || !edit_.json()[list].is_array()) return;
    GltfJson kept = GltfJson::array();
    for (const GltfJson& name : edit_.json()[list])
      if (name != kDracoExtension) kept.push_back(name);
    if (kept.empty()) {
      edit_.json().erase(list);
    } else {
      edit_.json()[list] = kept;
    }
  }

  const GltfSurface& surface_;
  const GltfColumns& columns_;
  GltfEdit& edit_;
  GltfAccessors accessors_;
  std::map<const GltfPrimitive*, uint64_t> indices_;            // of those unpacked
  std::map<uint64_t, std::map<GltfWishes, uint64_t>> granted_;  // by mesh: the mesh of a wish
};

}  // namespace

Status rewrite_gltf(std::span<const uint8_t> bytes, const std::string& name,
                    const GltfFilesBeside& beside, const MovedMesh& moved,
                    std::span<const EditedPicture> pictures, OutputBuffer& output,
                    std::vector<GltfFileBeside>& changed) {
  const FileSteps steps(output.budget());
  const auto document = open_gltf(bytes, beside, steps);
  if (!document.is_ok()) return changed_original(name, document.status().message());
  UnpackedViews views(*document, steps);
  const auto surface = read_gltf_surface(views);
  if (!surface.is_ok()) return changed_original(name, surface.status().message());
  if (!std::ranges::equal(surface->mesh.vertices, moved.before))
    return changed_original(name, "its positions are others");
  const GltfColumns columns = move_columns(*surface, moved);
  const auto is_inside = [](const EditedPicture& picture) { return picture.path.empty(); };
  if (!columns.is_changed() && std::ranges::none_of(pictures, is_inside)) {
    output.put_text({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    return Status::ok();
  }
  GltfEdit edit(*document, bytes);
  if (columns.is_changed()) GltfRewriter(*surface, columns, edit).rewrite();
  for (const EditedPicture& picture : pictures)
    if (is_inside(picture)) put_gltf_image(edit, picture.image, picture.bytes);
  return edit.write(output, changed);
}

}  // namespace burnish
