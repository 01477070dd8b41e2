#include "tests/bench/accuracy_soak.h"

#include <algorithm>
#include <cstdio>

#include "server/session/session.h"
#include "tests/bench/accuracy_runs.h"
#include "tests/reference/compare.h"

namespace burnish {

namespace {

constexpr int kFrames = 2000;
constexpr double kRiseMax = 1e-12;  // of the energy, from one frame to the next
constexpr double kDriftMax = 1e-5;  // of the diagonal
constexpr double kGrowthMax = 2;    // of the largest |u| over all corners, even without a vertex

double largest(std::span<const Vec3f> displacement) {
  double most = 0;
  for (const Vec3f& u : displacement) most = std::max(most, double{u.norm()});
  return most;
}

bool soak_one(Session& session, const std::string& name, const TransferCurve& curve,
              nlohmann::ordered_json& rows) {
  BURNISH_CHECK(session.apply({name, SetTransferCurve{curve}}).is_ok(), "a curve within limits");
  session.solve({.exact = true}).value();
  const auto settled = session.surface().vertices;
  const double largest_before = largest(session.solver().displacement());
  double energy = session.step().energy, rise = 0;
  for (int i = 1; i < kFrames; ++i) {
    const double next = session.step().energy;
    rise = std::max(rise, (next - energy) / std::abs(energy));
    energy = next;
  }
  const double largest_after = largest(session.solver().displacement());
  const auto drift = reference::vertex_distance(settled, session.surface().vertices,
                                                session.prepared().statistics.diagonal());
  const bool met =
      rise <= kRiseMax && drift.max <= kDriftMax && largest_after <= kGrowthMax * largest_before;
  std::printf(
      "  soak %-14s energy rose by %.1e, vertices drifted by %.1e, largest |u| of any "
      "corner %.2f then %.2f cells  %s\n",
      name.c_str(), rise, drift.max, largest_before, largest_after, met ? "met" : "MISSED");
  std::fflush(stdout);
  rows.push_back({{"row", "soak " + name},
                  {"energy_rise", rise},
                  {"drift_max", drift.max},
                  {"largest_before_cells", largest_before},
                  {"largest_after_cells", largest_after},
                  {"met", met}});
  return !met;
}

}  // namespace

int soak(const Multigrid& on, nlohmann::ordered_json& out) {
  const auto session = Session::open(on, {}).value();
  BURNISH_CHECK(session->apply({"beta", SetGradientScale{0}}).is_ok(), "0 is within limits");
  int missed = 0;
  missed += soak_one(*session, "alpha 1", TransferCurve(1), out["rows"]);
  missed += soak_one(*session, "alpha 50", TransferCurve(50), out["rows"]);
  missed += soak_one(*session, "contrast 1000", contrast_1000(), out["rows"]);
  return missed;
}

}  // namespace burnish
