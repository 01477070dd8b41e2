#include "common/generate/generate.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "common/base/text.h"
#include "common/generate/generate_kinds.h"
#include "common/generate/lattice.h"
#include "common/generate/scanner.h"
#include "common/generate/surface_noise.h"

namespace burnish {
namespace {

constexpr uint64_t kGeneratedVerticesMax = 50'000'000;

struct Recipe {
  GeneratedScanKind kind;
  uint64_t vertices_min;  ///< with fewer the kind loses its features
  TriangleMesh (*make)(const GeneratedScan& wanted);
  bool has_own_noise = false;
};

TriangleMesh nearest_icosphere(const GeneratedScan& wanted) {
  const auto excess = [&](int level) {
    return static_cast<int64_t>((uint64_t{10} << (2 * level)) + 2) -
           static_cast<int64_t>(wanted.vertices);
  };
  int level = 0;
  while (std::abs(excess(level + 1)) < std::abs(excess(level))) ++level;
  return make_icosphere(level, 1);
}

TriangleMesh nearest_cylinder(const GeneratedScan& wanted) {
  constexpr double kAroundOverAlong = 3.14;  // square quads at radius 1 and height 2
  const double wish = static_cast<double>(wanted.vertices);
  const int along = lattice_size(std::sqrt(wish / kAroundOverAlong) - 1, 1);
  return make_cylinder(lattice_size(wish / (along + 1), 3), along, 1, 2);
}

TriangleMesh nearest_sheet(const GeneratedScan& wanted) {
  return make_sheet(lattice_size(std::sqrt(static_cast<double>(wanted.vertices)) - 1, 1), 1, 0.1);
}

const std::vector<Recipe>& recipes() {
  static const std::vector<Recipe> all = {
      {{"tablet", "engraved stone fragment as scanned: noise, fracture faces, open underside"},
       1000,
       generate_tablet,
       true},
      {{"icosphere", "exact sphere from a split icosahedron"}, 12, nearest_icosphere},
      {{"cylinder", "exact open cylinder"}, 12, nearest_cylinder},
      {{"sheet", "exact open square with one smooth bump"}, 12, nearest_sheet},
      {{"blob", "closed lumpy surface with detail at every scale and fine noise"},
       26,
       generate_blob,
       true},
      {{"sheets", "two nearly parallel sheets, closer than a grid cell"},
       12,
       generate_sheets,
       true},
      {{"fan", "five pages meeting in one spine of non-manifold edges"}, 30, generate_fan, true},
      {{"soup", "overlapping noisy range scans whose triangles share no vertices"},
       36,
       generate_soup,
       true},
      {{"part", "machined part: flat faces, sharp edges, a boss and a through hole"},
       60,
       generate_part},
      {{"coin", "struck coin: a raised rim and lines of letters with steep flanks on a dome"},
       400,
       generate_coin},
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

Result<NoiseKind> parse_noise_kind(std::string_view word) {
  if (word == "range") return NoiseKind::kRange;
  if (word == "gauss") return NoiseKind::kGauss;
  if (word == "scanner") return NoiseKind::kScanner;
  return invalid_argument("noise '" + std::string(word) + "' is not range, gauss or scanner");
}

static Status unknown_kind(const std::string& kind) {
  std::string names;
  for (const Recipe& recipe : recipes())
    names += (names.empty() ? "" : ", ") + std::string(recipe.kind.name);
  return invalid_argument("unknown kind of scan '" + kind + "'; the kinds are " + names);
}

// Scanners interpolate and average, so half of the noise's power is smooth over two edges.
ScannerNoise wanted_noise(const TriangleMesh& mesh, const GeneratedScan& wanted,
                          const ScannerNoise& own) {
  if (!wanted.noise) return own;
  const double edge = mean_edge(mesh), part = *wanted.noise * edge / std::numbers::sqrt2;
  return {.white = part, .correlated = part, .correlation_length = 2 * edge};
}

// Adds a noise that no kind has by itself to the clean surface.
static TriangleMesh made_with_noise(const Recipe& recipe, const GeneratedScan& wanted) {
  GeneratedScan clean = wanted;
  clean.noise = 0;
  TriangleMesh mesh = recipe.make(clean);
  if (wanted.noise_kind == NoiseKind::kGauss)
    add_white_noise(mesh, *wanted.noise, wanted.seed);
  else
    add_structured_light_noise(mesh, *wanted.noise, wanted.seed);
  round_to_float(mesh);
  return mesh;
}

// Exact shapes keep their double positions if they get no noise.
static TriangleMesh made(const Recipe& recipe, const GeneratedScan& wanted) {
  if (wanted.noise.value_or(0) != 0 && wanted.noise_kind != NoiseKind::kRange)
    return made_with_noise(recipe, wanted);
  TriangleMesh mesh = recipe.make(wanted);
  if (recipe.has_own_noise || wanted.noise.value_or(0) == 0) return mesh;
  add_scanner_noise(mesh, wanted_noise(mesh, wanted, {}), wanted.seed);
  round_to_float(mesh);
  return mesh;
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
  if (scan.noise && !(*scan.noise >= 0 && *scan.noise <= kScannerNoiseMax))
    return invalid_argument("noise of " + shortest_text(*scan.noise) +
                            " mean edges is outside 0.." + shortest_text(kScannerNoiseMax));
  return made(*recipe, scan);
}

}  // namespace burnish
