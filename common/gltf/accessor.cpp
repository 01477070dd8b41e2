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

}  // namespace burnish
