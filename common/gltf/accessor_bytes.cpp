#include <algorithm>
#include <utility>

#include "common/gltf/accessor.h"

namespace burnish {

namespace {

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
