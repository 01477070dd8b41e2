#include "common/generate/generate.h"

#include <algorithm>
#include <cmath>

#include "common/generate/generate_kinds.h"
#include "common/generate/lattice.h"

namespace burnish {
namespace {

constexpr uint64_t kGeneratedVerticesMax = 50'000'000;

struct Recipe {
  GeneratedScanKind kind;
  uint64_t vertices_min;  ///< with fewer the kind loses its features
  TriangleMesh (*make)(uint64_t vertices, uint64_t seed);
};

TriangleMesh nearest_icosphere(uint64_t vertices, uint64_t /*seed*/) {
  const auto excess = [&](int level) {
    return static_cast<int64_t>((uint64_t{10} << (2 * level)) + 2) - static_cast<int64_t>(vertices);
  };
  int level = 0;
  while (std::abs(excess(level + 1)) < std::abs(excess(level))) ++level;
  return make_icosphere(level, 1);
}

TriangleMesh nearest_cylinder(uint64_t vertices, uint64_t /*seed*/) {
  constexpr double kAroundOverAlong = 3.14;  // square quads at radius 1 and height 2
  const double wish = static_cast<double>(vertices);
  const int along = lattice_size(std::sqrt(wish / kAroundOverAlong) - 1, 1);
  return make_cylinder(lattice_size(wish / (along + 1), 3), along, 1, 2);
}

TriangleMesh nearest_sheet(uint64_t vertices, uint64_t /*seed*/) {
  return make_sheet(lattice_size(std::sqrt(static_cast<double>(vertices)) - 1, 1), 1, 0.1);
}

const std::vector<Recipe>& recipes() {
  static const std::vector<Recipe> all = {
      {{"tablet", "engraved stone fragment as scanned: noise, fracture faces, open underside"},
       1000,
       generate_tablet},
      {{"icosphere", "exact sphere from a split icosahedron"}, 12, nearest_icosphere},
      {{"cylinder", "exact open cylinder"}, 12, nearest_cylinder},
      {{"sheet", "exact open square with one smooth bump"}, 12, nearest_sheet},
      {{"blob", "closed lumpy surface with detail at every scale and fine noise"},
       26,
       generate_blob},
      {{"sheets", "two nearly parallel sheets, closer than a grid cell"}, 12, generate_sheets},
      {{"fan", "five pages meeting in one spine of non-manifold edges"}, 30, generate_fan},
      {{"soup", "overlapping noisy range scans whose triangles share no vertices"},
       36,
       generate_soup},
      {{"part", "machined part: flat faces, sharp edges, a boss and a through hole"},
       60,
       generate_part},
      {{"wall", "thin wall from tomography: torn, with specks and non-manifold edges"},
       500,
       generate_wall},
  };
  return all;
}

}  // namespace

const std::vector<GeneratedScanKind>& generated_scan_kinds() {
  static const std::vector<GeneratedScanKind> kinds = [] {
    std::vector<GeneratedScanKind> result;
    for (const Recipe& recipe : recipes()) result.push_back(recipe.kind);
    return result;
  }();
  return kinds;
}

static Status unknown_kind(const std::string& kind) {
  std::string names;
  for (const Recipe& recipe : recipes())
    names += (names.empty() ? "" : ", ") + std::string(recipe.kind.name);
  return invalid_argument("unknown kind of scan '" + kind + "'; the kinds are " + names);
}

Result<TriangleMesh> generate_scan(const GeneratedScan& scan) {
  const auto& all = recipes();
  const auto recipe = std::find_if(all.begin(), all.end(),
                                   [&](const Recipe& r) { return r.kind.name == scan.kind; });
  if (recipe == all.end()) return unknown_kind(scan.kind);
  if (scan.vertices < recipe->vertices_min || scan.vertices > kGeneratedVerticesMax)
    return invalid_argument(scan.kind + " of " + std::to_string(scan.vertices) +
                            " vertices is outside " + std::to_string(recipe->vertices_min) + ".." +
                            std::to_string(kGeneratedVerticesMax));
  return recipe->make(scan.vertices, scan.seed);
}

}  // namespace burnish
