#include "server/solver/cpu/assembly/children.h"

#include <array>

namespace burnish::cpu {

// P of a child: the weights of its parent's eight corners at each of its own corners.
using ChildWeights = std::array<std::array<double, 8>, 8>;

static constexpr std::array<ChildWeights, 8> make_weights() {
  std::array<ChildWeights, 8> weights = {};
  for (int octant = 0; octant < 8; ++octant)
    for (int a = 0; a < 8; ++a)
      for (int parent = 0; parent < 8; ++parent) {
        double weight = 1;
        for (int axis = 0; axis < 3; ++axis) {
          const int half_steps = (octant >> axis & 1) + (a >> axis & 1);  // from the low corner
          weight *= (parent >> axis & 1) ? 0.5 * half_steps : 1 - 0.5 * half_steps;
        }
        weights[octant][a][parent] = weight;
      }
  return weights;
}

alignas(64) static constexpr std::array<ChildWeights, 8> kWeights = make_weights();

// Does Pᵀ from the left. Along each axis the child's corner in the parent's middle gives half to
// each side.
[[gnu::always_inline]] static inline void restrict_rows(int octant, Double8 (&rows)[8]) {
  for (int axis = 0; axis < 3; ++axis) {
    const int bit = 1 << axis;
    const int middle_bit = octant & bit ? 0 : bit;
    for (int a = 0; a < 8; ++a) {
      if (a & bit) continue;
      Double8& middle = rows[a | middle_bit];
      middle *= 0.5;
      rows[a | (bit ^ middle_bit)] += middle;
    }
  }
}

BURNISH_DISPATCH void add_restricted(const CellMatrix& child, int octant, RestrictedCell& sum) {
  const auto* p = reinterpret_cast<const Double8*>(&kWeights[octant]);
  double diagonal[8];
  for (int a = 0; a < 8; ++a) diagonal[a] = child.row_sum[a];
  for (int a = 0, k = 0; a < 8; ++a)
    for (int b = a + 1; b < 8; ++b, ++k) {
      diagonal[a] -= child.pair[k];
      diagonal[b] -= child.pair[k];
    }
  Double8 kp[8];
  for (int a = 0; a < 8; ++a) {
    kp[a] = diagonal[a] * p[a];
    sum.row_sum += child.row_sum[a] * p[a];
  }
  for (int a = 0, k = 0; a < 8; ++a)
    for (int b = a + 1; b < 8; ++b, ++k) {
      kp[a] += child.pair[k] * p[b];
      kp[b] += child.pair[k] * p[a];
    }
  restrict_rows(octant, kp);
  for (int a = 0; a < 8; ++a) sum.row[a] += kp[a];
}

CellMatrix RestrictedCell::packed() const {
  CellMatrix out;
  for (int a = 0, k = 0; a < 8; ++a) {
    out.row_sum[a] = row_sum[a];
    for (int b = a + 1; b < 8; ++b, ++k) out.pair[k] = row[a][b];
  }
  return out;
}

}  // namespace burnish::cpu
