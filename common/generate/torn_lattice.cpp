#include "common/generate/torn_lattice.h"

#include <limits>
#include <utility>

#include "common/generate/lattice.h"

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

std::vector<size_t> TornLattice::take_piece_of(size_t first) {
  std::vector<size_t> piece;
  const auto take = [&](size_t quad) {
    if (kept_[quad]) piece.push_back(quad);
    kept_[quad] = 0;
  };
  take(first);
  for (size_t i = 0; i < piece.size(); ++i) {
    const size_t quad = piece[i], column = quad % side_, row = quad / side_;
    if (column > 0) take(quad - 1);
    if (column + 2 < size_t(side_)) take(quad + 1);
    if (row > 0) take(quad - side_);
    if (row + 2 < size_t(side_)) take(quad + side_);
  }
  return piece;
}

void TornLattice::keep_largest_piece() {
  std::vector<size_t> largest;
  for (int row = 0; row < side_ - 1; ++row)
    for (int column = 0; column < side_ - 1; ++column) {
      std::vector<size_t> piece = take_piece_of(size_t(row) * side_ + column);
      if (piece.size() > largest.size()) largest = std::move(piece);
    }
  for (size_t quad : largest) kept_[quad] = 1;
}

TriangleMesh TornLattice::largest_piece() {
  tear_pinches();
  keep_largest_piece();
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
