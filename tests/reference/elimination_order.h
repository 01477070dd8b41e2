#pragma once

#include <vector>

#include "tests/reference/pieces.h"

namespace burnish::reference {

/// Returns an order to eliminate corners of the grid, by nested dissection: a lattice plane parts
/// the corners in two halves that share no cell; the halves come first, the plane last. Shapes: the
/// entries of `free`, indices into `corners`, each once.
std::vector<int> elimination_order(const std::vector<Lattice>& corners,
                                   const std::vector<int>& free);

}  // namespace burnish::reference
