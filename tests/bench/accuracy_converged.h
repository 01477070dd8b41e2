#pragma once

#include <memory>
#include <string>
#include <vector>

#include "server/session/session.h"
#include "server/solver/cycle/multigrid.h"

namespace burnish {

/// A converged surface, where it is from, and how well it is known.
struct ConvergedSurface {
  std::vector<Vec3d> vertices;
  std::string method;   ///< "cholmod", "reference" or "own"
  double known_to = 0;  ///< largest move of the last refinement, over the bounding-box diagonal
};

/// What sessions of one scan converge to: the reference's own matrix and constraint (tests/
/// reference shares no numerical code with the product), solved by CHOLMOD where the build has it,
/// else by the reference. Above kIndependentCornersMax corners the product's own solve, driven to
/// 1e-12, takes its place.
class Converged {
 public:
  Converged(const TriangleMesh& mesh, Multigrid on);
  ~Converged();

  /// The surface for the session's curve and its β of every cell as it is now.
  /// Cost: a factorisation whenever the curve is not that of the last call.
  ConvergedSurface of(const Session& session);

 private:
  struct Independent;
  ConvergedSurface own(const Session& session) const;

  Multigrid on_;
  std::unique_ptr<Independent> independent_;
};

}  // namespace burnish
