#pragma once

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "common/generate/generate.h"
#include "server/prepare/prepare.h"
#include "server/session/session.h"
#include "server/solver/tuning/plan_cycle.h"

namespace burnish {

/// A closed scan with detail of every size, about 2 across.
inline TriangleMesh lumpy_scan() {
  return generate_scan({"blob", 3000, 1}).value();
}

/// Opens a session over a scan on the CPU backend.
inline std::unique_ptr<Session> session_over(const TriangleMesh& mesh, int depth = 5,
                                             const Controls& controls = {}) {
  PrepareOptions options;
  options.depth = depth;
  const auto prepared = *prepare(mesh, options);
  auto opened =
      Session::open(*make_multigrid(prepared, {}), {.backend = BackendKind::kCpu}, controls);
  return std::move(opened).value();
}

/// Returns the surface after these changes, at the bar of exports.
inline TriangleMesh exact_surface(Session& session,
                                  const std::vector<decltype(Edit::change)>& changes) {
  for (const auto& change : changes)
    EXPECT_TRUE(session.apply({std::to_string(session.edited().history().size()), change}).is_ok());
  EXPECT_TRUE(session.solve({.exact = true}).is_ok());
  return session.surface();
}

inline double farthest(const TriangleMesh& a, const TriangleMesh& b) {
  double most = 0;
  for (size_t v = 0; v < a.vertices.size(); ++v)
    most = std::max(most, (a.vertices[v] - b.vertices[v]).norm());
  return most;
}

}  // namespace burnish
