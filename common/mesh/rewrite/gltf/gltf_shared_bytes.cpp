#include "common/mesh/rewrite/gltf/gltf_shared_bytes.h"

#include <algorithm>
#include <map>

#include "common/gltf/accessor.h"

namespace burnish {

namespace {

/// Bytes that something claims, and its number.
struct GltfClaim {
  uint64_t begin = 0;
  uint64_t end = 0;
  uint64_t owner = 0;
};

/// Marks the owners of claims that overlap.
void mark_overlaps(std::vector<GltfClaim>& claims, std::vector<bool>& is_shared) {
  std::ranges::sort(claims, {}, &GltfClaim::begin);
  const GltfClaim* furthest = nullptr;
  for (const GltfClaim& claim : claims) {
    if (furthest != nullptr && claim.begin < furthest->end)
      is_shared[claim.owner] = is_shared[furthest->owner] = true;
    if (furthest == nullptr || claim.end > furthest->end) furthest = &claim;
  }
}

std::vector<bool> find_shared_views(const GltfDocument& document) {
  std::vector<bool> is_shared(count_elements(document.json, "bufferViews"));
  std::map<uint64_t, std::vector<GltfClaim>> claims;  // by buffer
  for (uint64_t v = 0; v < is_shared.size(); ++v) {
    const GltfJson& view = document.json.at("bufferViews")[v];
    const GltfJson* packed = find_meshopt(view);
    for (const GltfJson* place : {&view, packed}) {
      if (place == nullptr) continue;
      const auto buffer = read_whole(*place, "buffer", ""),
                 offset = read_whole(*place, "byteOffset", "", 0),
                 bytes = read_whole(*place, "byteLength", "");
      if (buffer.is_ok() && offset.is_ok() && bytes.is_ok())
        claims[*buffer].push_back({*offset, *offset + *bytes, v});
    }
  }
  for (auto& [buffer, list] : claims) mark_overlaps(list, is_shared);
  return is_shared;
}

/// The accessors of one view, by the place of their elements within its stride.
struct GltfViewClaims {
  std::map<uint64_t, std::vector<GltfClaim>> by_place;
  std::map<uint64_t, uint64_t> ends;  // of the largest element at a place

  void mark(std::vector<bool>& is_shared) {
    uint64_t end = 0;
    std::vector<GltfClaim>* before = nullptr;
    for (auto& [place, claims] : by_place) {
      mark_overlaps(claims, is_shared);
      if (place < end) {
        for (const auto* list : {before, &claims})
          for (const GltfClaim& claim : *list) is_shared[claim.owner] = true;
      }
      end = std::max(end, ends[place]);
      before = &claims;
    }
  }
};

}  // namespace

std::vector<bool> find_shared_accessors(const GltfDocument& document) {
  const std::vector<bool> shared_views = find_shared_views(document);
  std::vector<bool> is_shared(count_elements(document.json, "accessors"));
  std::map<uint64_t, GltfViewClaims> views;
  for (uint64_t a = 0; a < is_shared.size(); ++a) {
    const GltfJson& json = document.json.at("accessors")[a];
    const auto view = read_whole(json, "bufferView", ""),
               offset = read_whole(json, "byteOffset", "", 0);
    if (!view.is_ok() || !offset.is_ok() || *view >= shared_views.size()) continue;
    const auto shape = read_accessor_shape(document, a, "");
    const auto stride = read_whole(document.json.at("bufferViews")[*view], "byteStride", "", 0);
    is_shared[a] = shared_views[*view] || !shape.is_ok() || !stride.is_ok();
    if (is_shared[a] || shape->count == 0) continue;
    const uint64_t size = shape->element.bytes();
    const uint64_t step = *stride == 0 ? size : *stride;
    const uint64_t place = *stride == 0 ? 0 : *offset % step;
    GltfViewClaims& claims = views[*view];
    claims.by_place[place].push_back({*offset, *offset + (shape->count - 1) * step + size, a});
    uint64_t& end = claims.ends[place];
    end = std::max(end, place + size);
  }
  for (auto& [view, claims] : views) claims.mark(is_shared);
  return is_shared;
}

}  // namespace burnish
