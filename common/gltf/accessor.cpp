#include "common/gltf/accessor.h"

#include <algorithm>
#include <array>
#include <limits>
#include <string_view>
#include <utility>

namespace burnish {

size_t component_bytes(GltfComponent component) {
  switch (component) {
    case GltfComponent::kByte:
    case GltfComponent::kUnsignedByte:
      return 1;
    case GltfComponent::kShort:
    case GltfComponent::kUnsignedShort:
      return 2;
    case GltfComponent::kUnsignedInt:
    case GltfComponent::kFloat:
      return 4;
  }
  return 4;
}

namespace {

template <typename T>
T number_at(const uint8_t* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof value);
  return value;
}

template <typename T>
float integer_at(const uint8_t* bytes, bool is_normalized) {
  const auto value = static_cast<float>(number_at<T>(bytes));
  constexpr auto kOne = static_cast<float>(std::numeric_limits<T>::max());
  return is_normalized ? std::max(value / kOne, -1.F) : value;
}

constexpr std::array<std::string_view, 4> kTypes = {"SCALAR", "VEC2", "VEC3", "VEC4"};

Status check_component(uint64_t value, const std::string& place) {
  if (value >= 5120 && value <= 5126 && value != 5124) return Status::ok();
  return invalid_argument(place + ": componentType is " + std::to_string(value) +
                          ", not one of 5120 to 5123, 5125, 5126");
}

/// Reads the bytes of `count` elements from a view. Fails if the view is shorter.
Status take_bytes(const GltfView& view, uint64_t offset, const std::string& place,
                  GltfAccessor& accessor) {
  const uint64_t size = accessor.element.bytes();
  accessor.stride = view.stride == 0 ? size : view.stride;
  if (accessor.stride < size)
    return invalid_argument(place + ": its elements have " + std::to_string(size) +
                            " bytes, but their stride is " + std::to_string(accessor.stride));
  const uint64_t room = view.bytes.size() < offset ? 0 : view.bytes.size() - offset;
  const uint64_t fits = room < size ? 0 : (room - size) / accessor.stride + 1;
  if (accessor.count > fits)
    return invalid_argument(place + " has " + std::to_string(accessor.count) +
                            " elements, but its view ends after " + std::to_string(fits));
  accessor.bytes = view.bytes.subspan(std::min<uint64_t>(offset, view.bytes.size()));
  return Status::ok();
}

/// Reads the indices or the values of a sparse accessor.
Status read_sparse_part(UnpackedViews& views, const GltfJson& sparse, const char* name,
                        const std::string& place, GltfAccessor& part) {
  const GltfJson* json = find_object(sparse, {name});
  if (json == nullptr) return invalid_argument(place + ": sparse has no " + name);
  ASSIGN_OR_RETURN(const uint64_t view_index, read_whole(*json, "bufferView", place));
  ASSIGN_OR_RETURN(const uint64_t offset, read_whole(*json, "byteOffset", place, 0));
  ASSIGN_OR_RETURN(GltfView view, views.view(view_index, place));
  view.stride = 0;
  return take_bytes(view, offset, place, part);
}

Status apply_sparse(UnpackedViews& views, const GltfJson& sparse, const std::string& place,
                    const GltfAccessor& accessor, std::vector<uint8_t>& made) {
  GltfAccessor indices, values;
  ASSIGN_OR_RETURN(indices.count, read_whole(sparse, "count", place));
  const GltfJson* json = find_object(sparse, {"indices"});
  if (json == nullptr) return invalid_argument(place + ": sparse has no indices");
  ASSIGN_OR_RETURN(const uint64_t component, read_whole(*json, "componentType", place));
  if (component != 5121 && component != 5123 && component != 5125)
    return invalid_argument(place + ": sparse indices of componentType " +
                            std::to_string(component));
  indices.element = {static_cast<GltfComponent>(component), 1, false};
  values.element = accessor.element;
  values.count = indices.count;
  RETURN_IF_ERROR(read_sparse_part(views, sparse, "indices", place, indices));
  RETURN_IF_ERROR(read_sparse_part(views, sparse, "values", place, values));
  const size_t size = accessor.element.bytes();
  for (uint64_t i = 0; i < indices.count; ++i) {
    const uint32_t target = indices.whole(i);
    if (target >= accessor.count)
      return invalid_argument(place + ": sparse index " + std::to_string(target) +
                              " is beyond its " + std::to_string(accessor.count) + " elements");
    std::memcpy(made.data() + target * size, values.bytes.data() + i * size, size);
  }
  return Status::ok();
}

/// Makes the elements of an accessor that is sparse or has no view: zeros, then the view's, then
/// the sparse ones.
Status make_elements(UnpackedViews& views, const GltfJson* sparse, const std::string& place,
                     GltfAccessor& accessor) {
  const size_t size = accessor.element.bytes();
  if (accessor.count > UINT64_MAX / size) return views.charge(UINT64_MAX);
  RETURN_IF_ERROR(views.charge(accessor.count * size));
  std::vector<uint8_t> made(accessor.count * size);
  if (!accessor.bytes.empty())
    for (uint64_t i = 0; i < accessor.count; ++i)
      std::memcpy(made.data() + i * size, accessor.bytes.data() + i * accessor.stride, size);
  if (sparse != nullptr) RETURN_IF_ERROR(apply_sparse(views, *sparse, place, accessor, made));
  set_made_bytes(accessor, std::move(made));
  return Status::ok();
}

}  // namespace

float GltfAccessor::number(uint64_t i, uint32_t component) const {
  const uint8_t* at = bytes.data() + i * stride + component * component_bytes(element.component);
  switch (element.component) {
    case GltfComponent::kByte:
      return integer_at<int8_t>(at, element.is_normalized);
    case GltfComponent::kUnsignedByte:
      return integer_at<uint8_t>(at, element.is_normalized);
    case GltfComponent::kShort:
      return integer_at<int16_t>(at, element.is_normalized);
    case GltfComponent::kUnsignedShort:
      return integer_at<uint16_t>(at, element.is_normalized);
    case GltfComponent::kUnsignedInt:
      return integer_at<uint32_t>(at, element.is_normalized);
    case GltfComponent::kFloat:
      return number_at<float>(at);
  }
  return 0;
}

uint32_t GltfAccessor::whole(uint64_t i) const {
  const uint8_t* at = bytes.data() + i * stride;
  if (element.component == GltfComponent::kUnsignedByte) return *at;
  if (element.component == GltfComponent::kUnsignedShort) return number_at<uint16_t>(at);
  return number_at<uint32_t>(at);
}

void set_made_bytes(GltfAccessor& accessor, std::vector<uint8_t> bytes) {
  accessor.made = std::make_shared<const std::vector<uint8_t>>(std::move(bytes));
  accessor.bytes = *accessor.made;
  accessor.stride = accessor.element.bytes();
  accessor.range.reset();
}

Result<GltfAccessor> read_accessor_shape(const GltfDocument& document, uint64_t index,
                                         const std::string& place) {
  ASSIGN_OR_RETURN(const GltfJson* json, find_element(document.json, "accessors", index, place));
  const std::string own_place = place_text("accessor", index);
  GltfAccessor accessor;
  accessor.index = index;
  ASSIGN_OR_RETURN(accessor.count, read_whole(*json, "count", own_place));
  ASSIGN_OR_RETURN(const uint64_t component, read_whole(*json, "componentType", own_place));
  RETURN_IF_ERROR(check_component(component, own_place));
  accessor.element.component = static_cast<GltfComponent>(component);
  const GltfJson* type = find_member(*json, "type");
  const auto found = type == nullptr || !type->is_string()
                         ? kTypes.end()
                         : std::ranges::find(kTypes, type->get<std::string>());
  if (found == kTypes.end())
    return invalid_argument(own_place + ": type is " +
                            (type == nullptr ? "(none)" : value_text(*type)) +
                            ", not SCALAR or VEC2 to VEC4");
  accessor.element.components = static_cast<uint32_t>(found - kTypes.begin()) + 1;
  const GltfJson* normalized = find_member(*json, "normalized");
  accessor.element.is_normalized =
      normalized != nullptr && normalized->is_boolean() && normalized->get<bool>();
  return accessor;
}

Result<GltfAccessor> read_accessor(UnpackedViews& views, uint64_t index, const std::string& place) {
  ASSIGN_OR_RETURN(GltfAccessor accessor, read_accessor_shape(views.document(), index, place));
  const GltfJson& json = views.document().json.at("accessors")[index];
  const std::string own_place = place_text("accessor", index);
  const GltfJson* sparse = find_object(json, {"sparse"});
  if (find_member(json, "bufferView") == nullptr) {
    RETURN_IF_ERROR(make_elements(views, sparse, own_place, accessor));
    return accessor;
  }
  ASSIGN_OR_RETURN(const uint64_t view_index, read_whole(json, "bufferView", own_place));
  ASSIGN_OR_RETURN(const uint64_t offset, read_whole(json, "byteOffset", own_place, 0));
  ASSIGN_OR_RETURN(const GltfView view, views.view(view_index, own_place));
  RETURN_IF_ERROR(take_bytes(view, offset, own_place, accessor));
  if (!view.is_packed) accessor.range = {view.buffer, view.offset + offset};
  if (sparse != nullptr) RETURN_IF_ERROR(make_elements(views, sparse, own_place, accessor));
  return accessor;
}

}  // namespace burnish
