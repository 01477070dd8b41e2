#pragma once

#include <memory>
#include <string>
#include <vector>

#include "common/mesh/triangle_mesh.h"
#include "server/session/session.h"

namespace burnish {

/// A session on a mesh that is prepared here, every step checked. Used on every backend.
class Filtered {
 public:
  Filtered(const TriangleMesh& mesh, int depth, const SolverOptions& options);

  Filtered& curve(const TransferCurve& curve);
  Filtered& alpha(double alpha) { return curve(TransferCurve(alpha)); }
  Filtered& beta(double beta);
  Filtered& paint(const Stroke& stroke);

  /// Vertices after exactly so many steps.
  std::vector<Vec3d> after(int cycles);
  /// Vertices once settled, or to the bar of exports.
  std::vector<Vec3d> settled() { return solved({}); }
  std::vector<Vec3d> exact() { return solved({.exact = true}); }

  Session& session() { return *session_; }
  double diagonal() const { return session_->prepared().statistics.diagonal(); }

 private:
  std::vector<Vec3d> solved(const SolveOptions& options);

  std::unique_ptr<Session> session_;
  int edits_ = 0;
};

/// Every backend that this build and machine offer, with the default smoother and the plainest: a
/// name for the test and its options.
struct BackendCase {
  std::string name;
  SolverOptions options;
};
std::vector<BackendCase> backend_cases();

/// The same with every smoother.
std::vector<BackendCase> every_smoother_cases();

}  // namespace burnish
