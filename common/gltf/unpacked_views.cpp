#include "common/gltf/unpacked_views.h"

#include <meshoptimizer.h>

#include "common/gltf/meshopt_attributes.h"

namespace burnish {

namespace {

/// The members of the extension.
struct Packing {
  std::string mode;
  std::string filter;
  uint64_t count = 0;
  uint64_t stride = 0;
};

std::string text_member(const GltfJson& object, const char* name, const char* absent) {
  const GltfJson* member = find_member(object, name);
  return member != nullptr && member->is_string() ? member->get<std::string>() : absent;
}

/// Checks what meshoptimizer takes for granted.
Status check_packing(const Packing& packing, const std::string& place) {
  constexpr uint64_t kVertexStrideMax = 256;
  const auto refused = [&](const std::string& why) {
    return invalid_argument(place + ": meshopt compression with " + why + " cannot be read");
  };
  const bool has_vertices = packing.mode == "ATTRIBUTES";
  const uint64_t s = packing.stride;
  if (!has_vertices && packing.mode != "TRIANGLES" && packing.mode != "INDICES")
    return refused("mode '" + packing.mode.substr(0, 40) + "'");
  if (has_vertices ? s == 0 || s % 4 != 0 || s > kVertexStrideMax : s != 2 && s != 4)
    return refused("byteStride " + std::to_string(s));
  if (packing.mode == "TRIANGLES" && packing.count % 3 != 0)
    return refused("count " + std::to_string(packing.count));
  const bool filter_fits =
      packing.filter == "NONE" ||
      (has_vertices &&
       (packing.filter == "EXPONENTIAL" || (packing.filter == "QUATERNION" && s == 8) ||
        ((packing.filter == "OCTAHEDRAL" || packing.filter == "COLOR") && (s == 4 || s == 8))));
  if (filter_fits) return Status::ok();
  return refused("filter '" + packing.filter.substr(0, 40) + "' and byteStride " +
                 std::to_string(s));
}

/// Debian 12's meshoptimizer does not know version 1.
int decode(const Packing& packing, std::span<const uint8_t> bytes, std::vector<uint8_t>& result) {
  if (packing.mode == "ATTRIBUTES" && is_meshopt_version_1(bytes))
    return unpack_meshopt_attributes(bytes, packing.stride, result) ? 0 : -1;
  if (packing.mode == "ATTRIBUTES")
    return meshopt_decodeVertexBuffer(result.data(), packing.count, packing.stride, bytes.data(),
                                      bytes.size());
  if (packing.mode == "TRIANGLES")
    return meshopt_decodeIndexBuffer(result.data(), packing.count, packing.stride, bytes.data(),
                                     bytes.size());
  return meshopt_decodeIndexSequence(result.data(), packing.count, packing.stride, bytes.data(),
                                     bytes.size());
}

void apply_filter(const Packing& packing, std::vector<uint8_t>& bytes) {
  if (packing.filter == "OCTAHEDRAL")
    meshopt_decodeFilterOct(bytes.data(), packing.count, packing.stride);
  if (packing.filter == "QUATERNION")
    meshopt_decodeFilterQuat(bytes.data(), packing.count, packing.stride);
  if (packing.filter == "EXPONENTIAL")
    meshopt_decodeFilterExp(bytes.data(), packing.count, packing.stride);
  if (packing.filter == "COLOR") apply_meshopt_colour_filter(bytes, packing.stride);
}

}  // namespace

Status UnpackedViews::charge(uint64_t bytes) {
  steps_.take();
  if (bytes <= document_.reading_bytes_max - charged_bytes_) {
    charged_bytes_ += bytes;
    return Status::ok();
  }
  return invalid_argument(
      "the scene unpacks to more than " + std::to_string(document_.reading_bytes_max) +
      " bytes, the limit for a file of " + std::to_string(document_.file_bytes));
}

Result<GltfView> UnpackedViews::raw_view(const GltfJson& json, const std::string& place) const {
  GltfView view;
  ASSIGN_OR_RETURN(view.buffer, read_whole(json, "buffer", place));
  ASSIGN_OR_RETURN(view.offset, read_whole(json, "byteOffset", place, 0));
  ASSIGN_OR_RETURN(view.stride, read_whole(json, "byteStride", place, 0));
  ASSIGN_OR_RETURN(const uint64_t length, read_whole(json, "byteLength", place));
  if (view.buffer >= document_.buffers.size())
    return invalid_argument(place + " refers to buffer " + std::to_string(view.buffer) +
                            ", but there are " + std::to_string(document_.buffers.size()));
  const std::span<const uint8_t> bytes = document_.buffers[view.buffer].bytes;
  if (view.offset > bytes.size() || length > bytes.size() - view.offset)
    return invalid_argument(place + " ends at byte " + std::to_string(view.offset + length) +
                            ", but buffer " + std::to_string(view.buffer) + " has " +
                            std::to_string(bytes.size()));
  view.bytes = bytes.subspan(view.offset, length);
  return view;
}

Result<GltfView> UnpackedViews::view(uint64_t index, const std::string& place) {
  ASSIGN_OR_RETURN(const GltfJson* json, find_element(document_.json, "bufferViews", index, place));
  const std::string own_place = place_text("bufferView", index);
  const GltfJson* packed = find_meshopt(*json);
  if (packed == nullptr) return raw_view(*json, own_place);
  return unpack(index, *packed, own_place);
}

Result<GltfView> UnpackedViews::unpack(uint64_t index, const GltfJson& packed,
                                       const std::string& place) {
  Packing packing{text_member(packed, "mode", ""), text_member(packed, "filter", "NONE")};
  ASSIGN_OR_RETURN(GltfView view, raw_view(packed, place));
  ASSIGN_OR_RETURN(packing.count, read_whole(packed, "count", place));
  packing.stride = view.stride;
  RETURN_IF_ERROR(check_packing(packing, place));
  const auto [found, is_new] = unpacked_.try_emplace(index);
  std::vector<uint8_t>& bytes = found->second;
  if (is_new) {
    if (packing.count > UINT64_MAX / packing.stride) return charge(UINT64_MAX);
    RETURN_IF_ERROR(charge(packing.count * packing.stride));
    bytes.resize(packing.count * packing.stride);
    if (decode(packing, view.bytes, bytes) != 0)
      return invalid_argument(place + ": its meshopt compression is damaged");
    apply_filter(packing, bytes);
  }
  view.bytes = bytes;
  view.is_packed = true;
  return view;
}

}  // namespace burnish
