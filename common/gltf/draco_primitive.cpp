#include "common/gltf/draco_primitive.h"

#include <array>
#include <cstring>
#include <utility>
#include <vector>

#include "common/gltf/decode_draco.h"

namespace burnish {

namespace {

template <typename T>
bool copy_values(const draco::PointAttribute& attribute, const GltfAccessor& accessor,
                 std::vector<uint8_t>& bytes) {
  const auto components = static_cast<int8_t>(accessor.element.components);
  const size_t size = accessor.element.bytes();
  for (uint32_t i = 0; i < accessor.count; ++i) {
    const draco::AttributeValueIndex value = attribute.mapped_index(draco::PointIndex(i));
    std::array<T, 4> numbers = {};
    if (value.value() >= attribute.size() ||
        !attribute.ConvertValue<T>(value, components, numbers.data()))
      return false;
    std::memcpy(bytes.data() + i * size, numbers.data(), size);
  }
  return true;
}

bool copy_values_of_type(const draco::PointAttribute& attribute, const GltfAccessor& accessor,
                         std::vector<uint8_t>& bytes) {
  switch (accessor.element.component) {
    case GltfComponent::kByte:
      return copy_values<int8_t>(attribute, accessor, bytes);
    case GltfComponent::kUnsignedByte:
      return copy_values<uint8_t>(attribute, accessor, bytes);
    case GltfComponent::kShort:
      return copy_values<int16_t>(attribute, accessor, bytes);
    case GltfComponent::kUnsignedShort:
      return copy_values<uint16_t>(attribute, accessor, bytes);
    case GltfComponent::kUnsignedInt:
      return copy_values<uint32_t>(attribute, accessor, bytes);
    case GltfComponent::kFloat:
      return copy_values<float>(attribute, accessor, bytes);
  }
  return false;
}

Result<GltfAccessor> read_attribute(UnpackedViews& views, const draco::Mesh& mesh,
                                    uint64_t accessor_index, uint64_t id,
                                    const std::string& place) {
  ASSIGN_OR_RETURN(GltfAccessor accessor,
                   read_accessor_shape(views.document(), accessor_index, place));
  const draco::PointAttribute* attribute = mesh.GetAttributeByUniqueId(static_cast<uint32_t>(id));
  if (attribute == nullptr)
    return invalid_argument(place + ": its Draco data have no attribute " + std::to_string(id));
  if (accessor.count != mesh.num_points())
    return invalid_argument(place + ": its Draco data have " + std::to_string(mesh.num_points()) +
                            " points, but accessor " + std::to_string(accessor_index) + " has " +
                            std::to_string(accessor.count));
  RETURN_IF_ERROR(views.charge(accessor.count * accessor.element.bytes()));
  std::vector<uint8_t> bytes(accessor.count * accessor.element.bytes());
  if (!copy_values_of_type(*attribute, accessor, bytes))
    return invalid_argument(place + ": Draco attribute " + std::to_string(id) + " is damaged");
  set_made_bytes(accessor, std::move(bytes));
  return accessor;
}

GltfAccessor indices_of(const draco::Mesh& mesh) {
  std::vector<uint8_t> bytes(size_t{mesh.num_faces()} * sizeof(draco::Mesh::Face));
  for (uint32_t f = 0; f < mesh.num_faces(); ++f) {
    const draco::Mesh::Face& face = mesh.face(draco::FaceIndex(f));
    const std::array<uint32_t, 3> corners = {face[0].value(), face[1].value(), face[2].value()};
    std::memcpy(bytes.data() + f * sizeof corners, corners.data(), sizeof corners);
  }
  GltfAccessor accessor;
  accessor.count = uint64_t{3} * mesh.num_faces();
  accessor.element = {GltfComponent::kUnsignedInt, 1, false};
  set_made_bytes(accessor, std::move(bytes));
  return accessor;
}

}  // namespace

Status read_draco(UnpackedViews& views, const GltfJson& json, const GltfJson& draco_json,
                  const std::string& place, GltfPrimitive& primitive) {
  ASSIGN_OR_RETURN(const uint64_t view_index, read_whole(draco_json, "bufferView", place));
  ASSIGN_OR_RETURN(const GltfView view, views.view(view_index, place));
  draco::Mesh mesh;
  RETURN_IF_ERROR(decode_draco(views, view.bytes, place, mesh));
  RETURN_IF_ERROR(views.charge(uint64_t{12} * mesh.num_faces()));
  primitive.mode = GltfMode::kTriangles;
  primitive.indices = indices_of(mesh);
  ASSIGN_OR_RETURN(primitive.indices->index, read_whole(json, "indices", place, kNoAccessor));
  const GltfJson* ids = find_object(draco_json, {"attributes"});
  const GltfJson* accessors = find_object(json, {"attributes"});
  if (ids == nullptr) return invalid_argument(place + ": its Draco data name no attributes");
  for (const auto& item : ids->items()) {
    const std::string& name = item.key();
    if (find_member(*accessors, name.c_str()) == nullptr) continue;
    ASSIGN_OR_RETURN(const uint64_t number, read_whole(*ids, name.c_str(), place));
    ASSIGN_OR_RETURN(const uint64_t index, read_whole(*accessors, name.c_str(), place));
    ASSIGN_OR_RETURN(GltfAccessor accessor, read_attribute(views, mesh, index, number, place));
    primitive.attributes.emplace(name, std::move(accessor));
  }
  return Status::ok();
}

}  // namespace burnish
