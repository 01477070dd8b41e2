#include <algorithm>
#include <cmath>
#include <string>

#include "common/pages/page.h"

namespace burnish {

namespace {

constexpr float kNormalTolerance = 1e-3f;

/// Says what is wrong with one page.
class Checker {
 public:
  explicit Checker(const Page& page) : page_(page) {}

  Status check() const {
    RETURN_IF_ERROR(count("vertices", page_.positions.size(), 1, kPageVerticesMax));
    RETURN_IF_ERROR(count("triangles", page_.triangles.size(), 1, kPageTrianglesMax));
    RETURN_IF_ERROR(count("border vertices", page_.border_vertices, 0, page_.positions.size()));
    RETURN_IF_ERROR(check_patches());
    RETURN_IF_ERROR(check_triangles());
    RETURN_IF_ERROR(check_positions());
    RETURN_IF_ERROR(check_normals());
    const size_t colours = page_.colours.empty() ? 0 : page_.positions.size();
    return count("colours", page_.colours.size(), colours, colours);
  }

 private:
  Status wrong(const std::string& what) const {
    return invalid_argument("page " + std::to_string(page_.id) + ": " + what);
  }

  Status count(const char* name, size_t value, size_t least, size_t most) const {
    if (value >= least && value <= most) return Status::ok();
    return wrong(std::to_string(value) + " " + name + ", it must be " + std::to_string(least) +
                 ".." + std::to_string(most));
  }

  Status check_patches() const {
    RETURN_IF_ERROR(count("patches", page_.patches.size(), 1, page_.triangles.size()));
    if (page_.patches.back().finer == kNoPage)
      RETURN_IF_ERROR(count("patches of level 0", page_.patches.size(), 1, 1));
    size_t triangles = 0;
    for (size_t p = 0; p < page_.patches.size(); ++p) {
      const PagePatch& patch = page_.patches[p];
      const std::string name = "patch " + std::to_string(p);
      if (patch.triangles == 0) return wrong(name + " has no triangle");
      if (patch.finer != kNoPage && patch.finer >= page_.id)
        return wrong(name + " replaces page " + std::to_string(patch.finer) +
                     ", which is not finer");
      if (p > 0 && patch.finer <= page_.patches[p - 1].finer)
        return wrong(name + " replaces page " + std::to_string(patch.finer) +
                     ", which is not above the one before");
      triangles += patch.triangles;
    }
    return count("triangles in patches", triangles, page_.triangles.size(), page_.triangles.size());
  }

  Status check_triangles() const {
    std::vector<uint8_t> is_used(page_.positions.size(), 0);
    for (size_t t = 0; t < page_.triangles.size(); ++t)
      for (const uint16_t vertex : page_.triangles[t]) {
        if (vertex >= page_.positions.size())
          return wrong("triangle " + std::to_string(t) + " refers to vertex " +
                       std::to_string(vertex) + " of " + std::to_string(page_.positions.size()));
        is_used[vertex] = 1;
      }
    const auto unused = std::ranges::find(is_used, 0);
    if (unused == is_used.end()) return Status::ok();
    return wrong("vertex " + std::to_string(unused - is_used.begin()) + " has no triangle");
  }

  Status check_positions() const {
    constexpr int kEnd = 1 << kPageGridBitsMax;
    for (size_t v = 0; v < page_.positions.size(); ++v)
      for (const int place : page_.positions[v])
        if (place < 0 || place >= kEnd)
          return wrong("vertex " + std::to_string(v) + " lies at " + std::to_string(place) +
                       ", the end is " + std::to_string(kEnd));
    return Status::ok();
  }

  Status check_normals() const {
    if (!page_.has_all_normals())
      RETURN_IF_ERROR(
          count("normals", page_.normals.size(), page_.border_vertices, page_.border_vertices));
    for (size_t v = 0; v < page_.normals.size(); ++v) {
      const float length = page_.normals[v].norm();
      if (!(std::abs(length - 1) <= kNormalTolerance))  // true for NaN
        return wrong("the normal of vertex " + std::to_string(v) + " has length " +
                     std::to_string(length) + ", it must be 1");
    }
    return Status::ok();
  }

  const Page& page_;
};

}  // namespace

Status check_page(const Page& page) {
  return Checker(page).check();
}

}  // namespace burnish
