#include "common/mesh/torn_lattice.h"

#include <limits>
#include <utility>

#include "common/mesh/lattice.h"

namespace burnish {

void TornLattice::keep_where(const std::function<bool(int, int, const Vec3d&)>& keep) {
#pragma omp parallel for schedule(dynamic, 16)
  for (int row = 0; row < side_ - 1; ++row)
    for (int column = 0; column < side_ - 1; ++column)
      if (!keep(column, row, vertex(column, row))) kept(column, row) = 0;
}

void TornLattice::tear_pinches() {
  for (bool torn = true; torn;) {
    torn = false;
    for (int row = 0; row + 2 < side_; ++row)
      for (int column = 0; column + 2 < side_; ++column) {
        uint8_t &a = kept(column, row), &b = kept(column + 1, row);
        uint8_t &c = kept(column, row + 1), &d = kept(column + 1, row + 1);
        if (a != d || b != c || a == b) continue;
        a = b = c = d = 0;
        torn = true;
      }
  }
}

std::vector<uint8_t> TornLattice::quads_around_the_middle() {
  std::vector<uint8_t> reached(kept_.size(), 0);
  std::vector<std::pair<int, int>> open = {{side_ / 2, side_ / 2}};
  while (!open.empty()) {
    const auto [column, row] = open.back();
    open.pop_back();
    if (column < 0 || row < 0 || column + 1 >= side_ || row + 1 >= side_) continue;
    uint8_t& here = reached[size_t(row) * side_ + column];
    if (here || !kept(column, row)) continue;
    here = 1;
    open.insert(open.end(),
                {{column - 1, row}, {column + 1, row}, {column, row - 1}, {column, row + 1}});
  }
  return reached;
}

TriangleMesh TornLattice::largest_piece() {
  tear_pinches();
  kept_ = quads_around_the_middle();
  TriangleMesh mesh;
  constexpr uint32_t kUnused = std::numeric_limits<uint32_t>::max();
  std::vector<uint32_t> new_index(vertices_.size(), kUnused);
  const auto index = [&](int column, int row) {
    uint32_t& v = new_index[size_t(row) * side_ + column];
    if (v == kUnused) {
      v = static_cast<uint32_t>(mesh.vertices.size());
      mesh.vertices.push_back(vertex(column, row));
    }
    return v;
  };
  for (int row = 0; row < side_ - 1; ++row)
    for (int column = 0; column < side_ - 1; ++column) {
      if (!kept(column, row)) continue;
      const uint32_t a = index(column, row), b = index(column + 1, row);
      const uint32_t c = index(column + 1, row + 1), d = index(column, row + 1);
      const auto& p = mesh.vertices;
      if ((p[a] - p[c]).squaredNorm() <= (p[b] - p[d]).squaredNorm())
        add_quad(mesh, a, b, c, d);
      else
        add_quad(mesh, b, c, d, a);
    }
  return mesh;
}

}  // namespace burnish
