#include "common/mesh/rewrite/gltf/gltf_accessors.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string_view>

#include "common/mesh/rewrite/gltf/gltf_shared_bytes.h"

namespace burnish {

static constexpr size_t kFloatsBytes = sizeof(Vec3f);

GltfAccessors::GltfAccessors(const GltfColumns& columns, GltfEdit& edit)
    : columns_(columns), edit_(edit), is_shared_(find_shared_accessors(edit.document())) {
  for (const GltfColumn& column : columns.all) accessor_of_.push_back(column.accessor.index);
}

/// Sets the bounds of an accessor's finite values, where it has some.
static void put_bounds(const std::vector<Vec3f>& values, GltfJson& json) {
  for (const char* name : {"min", "max"}) {
    if (!json.contains(name)) continue;
    const float sign = name == std::string_view("min") ? 1.F : -1.F;
    GltfJson bounds = GltfJson::array();
    for (int axis = 0; axis < 3; ++axis) {
      float least = INFINITY;
      for (const Vec3f& value : values)
        if (std::isfinite(value[axis])) least = std::min(least, sign * value[axis]);
      bounds.push_back(std::isfinite(least) ? double{sign * least} + 0.0 : 0.0);  // no -0
    }
    // Equal numbers stay as they are written: 1 and 1.0 are the same bound.
    if (json[name] != bounds) json[name] = bounds;
  }
}

static std::span<const uint8_t> bytes_of_values(const std::vector<Vec3f>& values) {
  return {reinterpret_cast<const uint8_t*>(values.data()), values.size() * kFloatsBytes};
}

static std::string_view text_of_values(const std::vector<Vec3f>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * kFloatsBytes};
}

/// Makes an accessor one of floats in a view of their own.
static void point_to_floats(uint64_t view, GltfJson& json) {
  json["bufferView"] = view;
  json["componentType"] = static_cast<uint32_t>(GltfComponent::kFloat);
  for (const char* member : {"byteOffset", "normalized", "sparse"}) json.erase(member);
}

bool GltfAccessors::can_patch(const GltfColumn& column) const {
  const GltfAccessor& accessor = column.accessor;
  return accessor.range && accessor.element.component == GltfComponent::kFloat &&
         !is_shared_[accessor.index];
}

void GltfAccessors::patch(const GltfColumn& column) {
  const GltfAccessor& accessor = column.accessor;
  const std::span<uint8_t> bytes =
      edit_.buffer(accessor.range->buffer).subspan(accessor.range->offset);
  for (uint64_t i = 0; i < accessor.count; ++i) {
    for (uint32_t axis = 0; axis < 3; ++axis) {
      const float value = column.values[i][axis];
      if (value == accessor.number(i, axis) || std::isnan(value)) continue;
      std::memcpy(bytes.data() + i * accessor.stride + axis * sizeof value, &value, sizeof value);
    }
  }
}

void GltfAccessors::put_floats(uint64_t accessor, const GltfColumn& column) {
  const uint64_t view = edit_.append_view(bytes_of_values(column.values), kFloatsBytes);
  GltfJson& json = edit_.json()["accessors"][accessor];
  point_to_floats(view, json);
  put_bounds(column.values, json);
  put_.insert(accessor);
}

void GltfAccessors::put_users(uint64_t accessor, const Users& users) {
  const GltfColumn& first = columns_.all[users.front()];
  const auto is_as_first = [&](size_t u) { return columns_.all[u].values == first.values; };
  if (std::ranges::all_of(users, is_as_first)) {
    if (!first.is_changed) return;
    if (!can_patch(first)) return put_floats(accessor, first);
    patch(first);
    return put_bounds(first.values, edit_.json()["accessors"][accessor]);
  }
  std::map<std::string_view, uint64_t> copies;  // by their bytes
  for (const size_t user : users) {
    const GltfColumn& column = columns_.all[user];
    if (!column.is_changed) continue;
    GltfJson& accessors = edit_.json()["accessors"];
    const auto [found, is_new] =
        copies.try_emplace(text_of_values(column.values), accessors.size());
    accessor_of_[user] = found->second;
    if (!is_new) continue;
    accessors.push_back(GltfJson(accessors[accessor]));
    put_floats(found->second, column);
  }
}

void GltfAccessors::put_columns() {
  std::map<uint64_t, Users> users;
  for (size_t c = 0; c < columns_.all.size(); ++c)
    users[columns_.all[c].accessor.index].push_back(c);
  for (const auto& [accessor, columns] : users) put_users(accessor, columns);
}

uint64_t GltfAccessors::put_unpacked(const GltfAccessor& accessor, bool is_vertex) {
  constexpr size_t kVertexAlignment = 4;
  GltfJson& accessors = edit_.json()["accessors"];
  const bool is_new = accessor.index == kNoAccessor;
  const uint64_t index = is_new ? accessors.size() : accessor.index;
  if (!is_new && !put_.insert(index).second) return index;
  const size_t size = accessor.element.bytes();
  const size_t stride =
      is_vertex ? (size + kVertexAlignment - 1) / kVertexAlignment * kVertexAlignment : size;
  std::vector<uint8_t> bytes(accessor.count * stride);
  for (uint64_t i = 0; i < accessor.count; ++i)
    std::memcpy(bytes.data() + i * stride, accessor.bytes.data() + i * accessor.stride, size);
  const uint64_t view = edit_.append_view(bytes, is_vertex ? stride : 0);
  if (is_new) accessors.push_back({{"type", "SCALAR"}});
  GltfJson& json = accessors[index];
  json["bufferView"] = view;
  json["componentType"] = static_cast<uint32_t>(accessor.element.component);
  json["count"] = accessor.count;
  for (const char* member : {"byteOffset", "sparse"}) json.erase(member);
  return index;
}

}  // namespace burnish
