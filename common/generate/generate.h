#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/base/status.h"
#include "common/mesh/triangle_mesh.h"

namespace burnish {

/// The kind of noise that a generated scan gets.
enum class NoiseKind {
  kRange,    ///< a range scanner's: half of its power is smooth over two edges
  kGauss,    ///< Gaussian, of each vertex's own
  kScanner,  ///< structured light: alike over three edges, and steps of depth of twice its
             ///< deviation
};

/// A scan that the program generates, for demos, tests and benchmarks.
struct GeneratedScan {
  std::string kind;             ///< one of generated_scan_kinds()
  uint64_t vertices = 100'000;  ///< wanted; the kind's nearest count is taken
  uint64_t seed = 1;            ///< same seed, same mesh, on every machine
  /// Deviation of the scanner's noise, over the mean edge, within 15 %. It replaces the noise that
  /// the kind has by itself; a wall keeps its densities'. Same vertices and triangles for every
  /// noise.
  std::optional<double> noise = {};
  NoiseKind noise_kind = NoiseKind::kRange;  ///< of `noise`
};

inline constexpr double kScannerNoiseMax = 1;  ///< over the mean edge

struct GeneratedScanKind {
  std::string_view name;
  std::string_view description;  ///< one line for the help text
};

/// tablet, icosphere, cylinder, sheet, blob, sheets, fan, soup, part, coin, wall
/// (docs/benchmarks.md, "The scans").
const std::vector<GeneratedScanKind>& generated_scan_kinds();

/// Returns the kind of noise of this word: range, gauss or scanner. Fails: invalid_argument.
Result<NoiseKind> parse_noise_kind(std::string_view word);

/// Generates a valid, consistently oriented mesh; closed meshes face outwards. The exact shapes
/// (icosphere, cylinder, sheet, part, coin) keep double positions; the others are rounded to float.
/// Fails: invalid_argument for an unknown kind, a count outside the kind's limits, or noise outside
/// 0 to kScannerNoiseMax.
Result<TriangleMesh> generate_scan(const GeneratedScan& scan);

/// Makes a sphere around the origin: an icosahedron split `level` times (10·4^level + 2 vertices),
/// with every vertex on the sphere. Needs: level 0 to 13.
TriangleMesh make_icosphere(int level, double radius);

/// Makes an open cylinder around z, from z = -height/2 to height/2, of `around` × `along` quads
/// split in two.
TriangleMesh make_cylinder(int around, int along, double radius, double height);

/// Makes the graph z = bump(x, y) over [0, width]² of `side` × `side` quads. The bump is Gaussian
/// with this height and a deviation of width/10; the sheet is flat for height 0.
TriangleMesh make_sheet(int side, double width, double bump_height);

}  // namespace burnish
