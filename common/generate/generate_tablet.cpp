#include <algorithm>
#include <cmath>

#include "common/generate/generate_kinds.h"
#include "common/generate/lattice.h"
#include "common/generate/noise.h"
#include "common/generate/scanner.h"
#include "common/generate/tablet_stone.h"
#include "common/generate/torn_lattice.h"

namespace burnish {

/// Numbers of lattice lines from the centre to the face's rim, and to the border.
struct TabletLattice {
  int rim, border;

  int side() const { return 2 * border + 1; }
};

static TabletLattice tablet_lattice(uint64_t vertices) {
  constexpr double kKept = 0.942;          // part of the lattice that tearing leaves
  constexpr double kBorderOverRim = 1.24;  // even spacing over face, flanks and underside
  const int border = lattice_size((std::sqrt(static_cast<double>(vertices) / kKept) - 1) / 2, 8);
  return {lattice_size(border / kBorderOverRim, 4), border};
}

/// Returns the lattice point's place on the stone, jittered as scanners sample. The rim is not
/// jittered: it would be saw-toothed.
static StonePlace place_of(const TabletLattice& lattice, int column, int row, uint64_t seed) {
  constexpr double kJitter = 0.5;  // of the spacing, from end to end
  const int i = column - lattice.border, j = row - lattice.border;
  const bool on_rim = std::max(std::abs(i), std::abs(j)) == lattice.rim;
  const uint64_t draw = 2 * (static_cast<uint64_t>(row) * lattice.side() + column);
  const auto jitter = [&](uint64_t axis) {
    return on_rim ? 0 : kJitter * (uniform(seed, draw + axis) - 0.5);
  };
  const double x = i + jitter(0), y = j + jitter(1);
  const double reach = std::max(std::abs(x), std::abs(y));
  StonePlace place;
  if (reach > 0) place.towards = {x / reach, y / reach};
  place.on_face = std::min(reach / lattice.rim, 1.0);
  place.past_rim = std::clamp((reach - lattice.rim) / (lattice.border - lattice.rim), 0.0, 1.0);
  return place;
}

/// Tears the border and a few holes that the scanner could not see into.
static void tear(TornLattice& lattice, const TabletLattice& size, uint64_t seed) {
  const int side = size.side();
  lattice.keep_where([&](int column, int row, const Vec3d& p) {
    const int reach = std::max(std::abs(column - size.border), std::abs(row - size.border));
    const double past_rim = static_cast<double>(reach - size.rim) / (size.border - size.rim);
    return past_rim < 0.86 + 0.35 * fractal_noise(p / 30, 3, seed);
  });
  constexpr int kHoles = 9;
  for (int hole = 0; hole < kHoles; ++hole) {
    const uint64_t own_seed = sub_seed(seed, 1 + hole);
    const bool on_face = hole < 2;
    const double from = on_face ? 0.1 : 0.93, to = on_face ? 0.85 : 0.97;
    const auto along = [&](uint64_t draw) {
      return static_cast<int>(uniform(own_seed, draw) * side);
    };
    const auto across = static_cast<int>((from + (to - from) * uniform(own_seed, 2)) * side);
    const Vec3d centre = hole % 2 == 0 ? lattice.vertex(along(0), across)
                                       : lattice.vertex(side - 1 - across, along(1));
    const double radius = (on_face ? 2.0 : 5.0) * (1 + uniform(own_seed, 3));
    lattice.keep_where([&](int, int, const Vec3d& p) {
      const double distance = (p - centre).norm();
      return distance > 2 * radius ||
             distance > radius * (1 + 0.5 * gradient_noise(p / radius, own_seed));
    });
  }
}

TabletStone generated_tablet_stone(uint64_t seed) {
  return TabletStone(sub_seed(seed, 0));
}

TriangleMesh generate_tablet(const GeneratedScan& wanted) {
  const TabletLattice size = tablet_lattice(wanted.vertices);
  const TabletStone stone = generated_tablet_stone(wanted.seed);
  TornLattice lattice(size.side());
#pragma omp parallel for schedule(dynamic, 16)
  for (int row = 0; row < size.side(); ++row)
    for (int column = 0; column < size.side(); ++column)
      lattice.vertex(column, row) =
          stone.point(place_of(size, column, row, sub_seed(wanted.seed, 1)));
  tear(lattice, size, sub_seed(wanted.seed, 2));
  TriangleMesh mesh = lattice.largest_piece();
  add_scanner_noise(
      mesh,
      wanted_noise(mesh, wanted, {.white = 0.08, .correlated = 0.13, .correlation_length = 3.5}),
      sub_seed(wanted.seed, 3));
  round_to_float(mesh);
  return mesh;
}

}  // namespace burnish
