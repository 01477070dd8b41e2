#include "common/mesh/joined_mesh.h"

#include <algorithm>
#include <array>
#include <bit>
#include <functional>
#include <tuple>

#include "common/base/heard_groups.h"

namespace burnish {
namespace {

/// The bits of a position. Vertices at one place have the same: minus zero is at the place of zero.
std::array<uint64_t, 3> bits_of(const Vec3d& position) {
  std::array<uint64_t, 3> bits;
  for (int axis = 0; axis < 3; ++axis) bits[axis] = std::bit_cast<uint64_t>(position[axis] + 0.0);
  return bits;
}

uint32_t hash_of(const Vec3d& position) {
  uint64_t hash = 0;
  for (const uint64_t bits : bits_of(position)) {
    hash = (hash ^ bits) * 0x9E3779B97F4A7C15u;
    hash ^= hash >> 32;
  }
  return static_cast<uint32_t>(hash);
}

/// Vertices of a bucket. Its bounds then fit into a core's cache.
constexpr size_t kVerticesPerBucket = 16;

/// Vertices with their hashes above them, by buckets of hashes.
struct Buckets {
  ScratchArray<uint64_t> start;  ///< buckets + 2, into `item`
  ScratchArray<uint64_t> item;

  size_t count() const { return start.size() - 2; }
  std::span<uint64_t> operator[](size_t bucket) {
    return {item.data() + start[bucket], item.data() + start[bucket + 1]};
  }
};

// Counts a bucket two places further up, so that filling moves each start to its own place.
Buckets make_buckets(std::span<const Vec3d> vertices, const ScratchSpace& space,
                     const LoopPart& part) {
  const size_t count = vertices.size() / kVerticesPerBucket + 1;
  Buckets buckets = {ScratchArray<uint64_t>(space, count + 2),
                     ScratchArray<uint64_t>(space, vertices.size())};
  const auto bucket_of = [&](uint64_t hash) { return hash * count >> 32; };
  for_each_heard(part.of(0, 0.4), vertices.size(),
                 [&](size_t v) { ++buckets.start[bucket_of(hash_of(vertices[v])) + 2]; });
  for (size_t i = 2; i < buckets.start.size(); ++i) buckets.start[i] += buckets.start[i - 1];
  for_each_heard(part.of(0.4, 1), vertices.size(), [&](size_t v) {
    const uint64_t hash = hash_of(vertices[v]);
    buckets.item[buckets.start[bucket_of(hash) + 1]++] = hash << 32 | v;
  });
  return buckets;
}

/// Enters the least of vertices of one hash at each place. Sorts, because they may be all vertices.
template <typename Sort>
void find_least(std::span<const Vec3d> vertices, std::span<uint64_t> same_hash,
                ScratchArray<uint32_t>& least, const Sort& sort) {
  const auto vertex = [](uint64_t hashed) { return static_cast<uint32_t>(hashed); };
  const auto bits = [&](uint64_t hashed) { return bits_of(vertices[vertex(hashed)]); };
  const auto key = [&](uint64_t hashed) { return std::tuple(bits(hashed), vertex(hashed)); };
  if (same_hash.size() > 1)
    sort(same_hash, [&](uint64_t a, uint64_t b) { return key(a) < key(b); });
  for (size_t i = 0; i < same_hash.size(); ++i) {
    const uint32_t v = vertex(same_hash[i]);
    const bool is_same = i > 0 && vertices[v] == vertices[vertex(same_hash[i - 1])];
    least[v] = is_same ? least[vertex(same_hash[i - 1])] : v;
  }
}

template <typename Sort>
void find_least_in_bucket(std::span<const Vec3d> vertices, std::span<uint64_t> bucket,
                          ScratchArray<uint32_t>& least, const Sort& sort) {
  sort(bucket, std::less<>());
  for (size_t i = 0; i < bucket.size();) {
    size_t end = i + 1;
    while (end < bucket.size() && bucket[end] >> 32 == bucket[i] >> 32) ++end;
    find_least(vertices, bucket.subspan(i, end - i), least, sort);
    i = end;
  }
}

bool have_joins(const ScratchArray<uint32_t>& least) {
  for (size_t v = 0; v < least.size(); ++v)
    if (least[v] != v) return true;
  return false;
}

}  // namespace

ScratchArray<uint32_t> least_at_places(std::span<const Vec3d> vertices, const ScratchSpace& space,
                                       const LoopPart& part) {
  Buckets buckets = make_buckets(vertices, space, part.of(0, 0.4));
  ScratchArray<uint32_t> least(space, vertices.size());
  for_each_group_heard(
      part.of(0.4, 1), buckets.count(), [&](size_t b) { return buckets[b].size(); },
      [&](size_t b, const auto& sort) { find_least_in_bucket(vertices, buckets[b], least, sort); });
  return least;
}

JoinedMesh::JoinedMesh(const MeshView& mesh, const ScratchSpace& space, const LoopPart& part)
    : view_(mesh) {
  const ScratchArray<uint32_t> least = least_at_places(mesh.vertices, space, part.of(0, 0.9));
  if (!have_joins(least)) return;
  triangles_ = ScratchArray<Triangle>(space, mesh.triangles.size());
  parallel_for_heard(part.of(0.9, 1), triangles_.size(), [&](size_t t) {
    for (int side = 0; side < 3; ++side) triangles_[t][side] = least[mesh.triangles[t][side]];
  });
  view_.triangles = {triangles_.data(), triangles_.size()};
}

}  // namespace burnish
