#include "common/gltf/primitive.h"

#include "common/gltf/draco_primitive.h"

namespace burnish {

std::string primitive_text(uint64_t mesh, uint64_t number) {
  return place_text("mesh", mesh) + ", " + place_text("primitive", number);
}

const GltfAccessor* GltfPrimitive::find(const std::string& name) const {
  const auto found = attributes.find(name);
  return found == attributes.end() ? nullptr : &found->second;
}

namespace {

bool is_float_or_small(const GltfElement& element) {
  return element.component != GltfComponent::kUnsignedInt;
}

/// Checks the shapes that glTF and KHR_mesh_quantization allow.
Status check_shapes(const GltfPrimitive& primitive, const std::string& place) {
  const auto refused = [&](const char* what, const GltfElement& element) {
    return invalid_argument(
        place + ": " + what + " of " + std::to_string(element.components) + " components of type " +
        std::to_string(static_cast<uint32_t>(element.component)) + " cannot be read");
  };
  for (const char* name : {"POSITION", "NORMAL"}) {
    const GltfAccessor* found = primitive.find(name);
    if (found == nullptr) continue;
    if (found->element.components != 3 || !is_float_or_small(found->element))
      return refused(name, found->element);
  }
  const GltfAccessor* colours = primitive.find("COLOR_0");
  if (colours != nullptr &&
      (colours->element.components < 3 || !is_float_or_small(colours->element)))
    return refused("COLOR_0", colours->element);
  if (primitive.indices) {
    const GltfElement element = primitive.indices->element;
    const bool is_unsigned = element.component == GltfComponent::kUnsignedByte ||
                             element.component == GltfComponent::kUnsignedShort ||
                             element.component == GltfComponent::kUnsignedInt;
    if (element.components != 1 || !is_unsigned) return refused("indices", element);
  }
  return Status::ok();
}

Status check_counts(const GltfPrimitive& primitive, const std::string& place, FileSteps& steps) {
  const uint64_t vertices = primitive.positions().count;
  for (const auto& [name, accessor] : primitive.attributes)
    if (accessor.count != vertices)
      return invalid_argument(place + " has " + std::to_string(accessor.count) + " elements of " +
                              name + " for " + std::to_string(vertices) + " positions");
  if (!primitive.indices) return Status::ok();
  for (uint64_t i = 0; i < primitive.indices->count; ++i) {
    steps.take();
    if (primitive.corner(i) >= vertices)
      return invalid_argument(place + ": index " + std::to_string(i) + " is vertex " +
                              std::to_string(primitive.corner(i)) + ", but there are " +
                              std::to_string(vertices) + ", numbered from 0");
  }
  return Status::ok();
}

Status read_plain(UnpackedViews& views, const GltfJson& json, const std::string& place,
                  GltfPrimitive& primitive) {
  const GltfJson* attributes = find_object(json, {"attributes"});
  for (const char* name : {"POSITION", "NORMAL", "COLOR_0"}) {
    if (find_member(*attributes, name) == nullptr) continue;
    ASSIGN_OR_RETURN(const uint64_t index, read_whole(*attributes, name, place));
    ASSIGN_OR_RETURN(GltfAccessor accessor, read_accessor(views, index, place));
    primitive.attributes.emplace(name, std::move(accessor));
  }
  if (find_member(json, "indices") == nullptr) return Status::ok();
  ASSIGN_OR_RETURN(const uint64_t index, read_whole(json, "indices", place));
  ASSIGN_OR_RETURN(primitive.indices, read_accessor(views, index, place));
  return Status::ok();
}

}  // namespace

Result<std::optional<GltfPrimitive>> read_primitive(UnpackedViews& views, uint64_t mesh,
                                                    uint64_t number) {
  const std::string place = primitive_text(mesh, number);
  const GltfJson& json = views.document().json.at("meshes")[mesh].at("primitives")[number];
  GltfPrimitive primitive{.mesh = mesh, .number = number};
  ASSIGN_OR_RETURN(const uint64_t mode, read_whole(json, "mode", place, 4));
  if (mode > 6) return invalid_argument(place + ": mode " + std::to_string(mode) + " is above 6");
  const GltfJson* attributes = find_object(json, {"attributes"});
  if (mode < 4 || attributes == nullptr || find_member(*attributes, "POSITION") == nullptr)
    return std::optional<GltfPrimitive>();
  if (find_member(json, "targets") != nullptr)
    return invalid_argument(place + " has morph targets, which Burnish cannot edit; apply them");
  primitive.mode = static_cast<GltfMode>(mode);
  const GltfJson* draco = find_object(json, {"extensions", kDracoExtension});
  primitive.is_draco = draco != nullptr;
  RETURN_IF_ERROR(primitive.is_draco ? read_draco(views, json, *draco, place, primitive)
                                     : read_plain(views, json, place, primitive));
  if (primitive.find("POSITION") == nullptr)
    return invalid_argument(place + ": its Draco data have no POSITION");
  RETURN_IF_ERROR(check_shapes(primitive, place));
  RETURN_IF_ERROR(views.charge(sizeof(uint32_t) * primitive.corner_count()));
  RETURN_IF_ERROR(check_counts(primitive, place, views.steps()));
  return std::optional(std::move(primitive));
}

}  // namespace burnish
