#pragma once

#include <memory>
#include <string>
#include <vector>

#include "server/session/session.h"
#include "server/solver/cycle/multigrid.h"

namespace burnish {

/// A converged surface, its source, and its accuracy.
struct ConvergedSurface {
  std::vector<Vec3d> vertices;
  std::string method;   ///< "cholmod", "reference" or "own"
  double known_to = 0;  ///< largest move of the last refinement, over the bounding-box diagonal
};

/// The converged surfaces of one scan's sessions. It uses the reference's own matrix and constraint
/// (tests/reference shares no numerical code with the product). CHOLMOD solves them if the build
/// has it, else the reference does. Above kIndependentCornersMax corners it uses the product's own
/// solve to 1e-12.
class Converged {
 public:
  Converged(const TriangleMesh& mesh, Multigrid on);
  ~Converged();

  /// Returns the surface for the session's present curve and β of every cell. Cost: a factorisation
  /// if the curve differs from the last call's.
  ConvergedSurface of(const Session& session);

 private:
  struct Independent;
  ConvergedSurface own(const Session& session) const;

  Multigrid on_;
  std::unique_ptr<Independent> independent_;
};

}  // namespace burnish
