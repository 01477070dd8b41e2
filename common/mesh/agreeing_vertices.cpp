#include "common/mesh/agreeing_vertices.h"

#include <algorithm>
#include <utility>

#include "common/mesh/corner_normals.h"
#include "common/mesh/joined_mesh.h"

namespace burnish {
namespace {

constexpr uint32_t kNoLook = 0xffffffff;

/// A vertex by itself, beside others at its place.
struct Look {
  Vec3f normal = Vec3f::Zero();  ///< of length 1; of no length without triangles of any area
  uint32_t next = kNoLook;       ///< vertex at the place that looks otherwise; kNoLook: none
};

/// Marks the vertices that have a place with others. Returns an empty array if there are none.
ScratchArray<uint8_t> find_meetings(const ScratchArray<uint32_t>& least,
                                    const ScratchSpace& space) {
  ScratchArray<uint8_t> meets(space, least.size());
  bool have_met = false;
  for (size_t v = 0; v < least.size(); ++v) {
    if (least[v] == v) continue;
    meets[v] = meets[least[v]] = 1;
    have_met = true;
  }
  return have_met ? std::move(meets) : ScratchArray<uint8_t>();
}

ScratchArray<Look> looks_of(const MeshView& mesh, const ScratchArray<uint8_t>& meets,
                            const ScratchSpace& space, const LoopPart& part) {
  ScratchArray<Look> looks(space, meets.size());
  std::ranges::fill(looks, Look{});
  for_each_heard(part, mesh.triangles.size(), [&](size_t i) {
    const Triangle& t = mesh.triangles[i];
    if (!meets[t[0]] && !meets[t[1]] && !meets[t[2]]) return;
    const auto normals =
        corner_normals(mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]);
    for (int corner = 0; corner < 3; ++corner)
      looks[t[corner]].normal += normals[corner].cast<float>();
  });
  for (Look& look : looks) look.normal = look.normal.stableNormalized();
  return looks;
}

/// Returns the cosine above which normals agree. A soup says nothing of creases, and the normal of
/// one triangle is rough: there all agree but those that face each other.
float least_cosine(const MeshView& mesh) {
  const bool is_soup = mesh.vertices.size() >= 3 * mesh.triangles.size();
  return is_soup ? -0.5F : 0.5F;
}

/// Finds the first vertex of the place that a vertex agrees with.
class Agreement {
 public:
  Agreement(ScratchArray<Look> looks, const MeshView& mesh)
      : looks_(std::move(looks)), colours_(mesh.colours), cosine_(least_cosine(mesh)) {}

  /// `least`: at the place of `vertex`. A hostile file has many looks at one place; those beyond
  /// the limit stay alone.
  uint32_t find(uint32_t least, uint32_t vertex) {
    constexpr int kLooksMax = 16;
    uint32_t other = least;
    for (int looks = 1; !agree(other, vertex); ++looks) {
      if (looks == kLooksMax) return vertex;
      if (looks_[other].next == kNoLook) return looks_[other].next = vertex;
      other = looks_[other].next;
    }
    return other;
  }

 private:
  // A vertex without a normal of its own takes any, but must not bring two sides together.
  bool agree(uint32_t known, uint32_t vertex) const {
    if (known == vertex) return true;
    if (!colours_.empty() && colours_[known] != colours_[vertex]) return false;
    const Vec3f& normal = looks_[vertex].normal;
    if (normal.isZero(0)) return true;
    return !looks_[known].normal.isZero(0) && looks_[known].normal.dot(normal) > cosine_;
  }

  ScratchArray<Look> looks_;
  std::span<const Rgba8> colours_;
  float cosine_;
};

}  // namespace

ScratchArray<uint32_t> least_that_agree(const MeshView& mesh, const ScratchSpace& space,
                                        const LoopPart& part) {
  ScratchArray<uint32_t> least = least_at_places(mesh.vertices, space, part);
  const ScratchArray<uint8_t> meets = find_meetings(least, space);
  if (meets.empty()) return {};
  Agreement agreement(looks_of(mesh, meets, space, part), mesh);
  for_each_heard(part, least.size(), [&](size_t i) {
    const auto v = static_cast<uint32_t>(i);
    least[v] = agreement.find(least[v], v);
  });
  return least;
}

}  // namespace burnish
