#include "tests/bench/denoise_filter.h"

#include <cmath>

#include "common/denoise/edge_proposal.h"
#include "common/edit/wavelength.h"
#include "common/mesh/statistics/statistics.h"
#include "server/prepare/prepare.h"
#include "server/session/session.h"
#include "server/solver/tuning/plan_cycle.h"
#include "tests/common/denoise/shape_error.h"

namespace burnish {
namespace {

using Changes = std::vector<Change>;

Result<TriangleMesh> filtered(const TriangleMesh& mesh, const Changes& changes) {
  ASSIGN_OR_RETURN(const auto prepared, prepare(mesh, {}));
  ASSIGN_OR_RETURN(const Multigrid on, make_multigrid(prepared));
  ASSIGN_OR_RETURN(const auto session, Session::open(on, {.backend = BackendKind::kCpu}));
  for (size_t i = 0; i < changes.size(); ++i)
    RETURN_IF_ERROR(session->apply({std::to_string(i), changes[i]}));
  RETURN_IF_ERROR(session->solve({.exact = true}).status());
  return session->surface();
}

SetTransferCurve wave_of(const TriangleMesh& mesh, double edges) {
  const MeshStatistics of = compute_statistics(mesh);
  return {TransferCurve(alpha_of_wavelength(std::sqrt(of.area), edges * of.mean_edge_length))};
}

void add(const NoisyShape& shape, const std::string& method, const TriangleMesh& aim,
         const TriangleMesh& mesh, BenchTable& table) {
  const ShapeError error = shape_error(aim, mesh);
  table.add({shape.shape, shape.noise, method, error.angle, error.distance, error.volume,
             100 * turned_share(aim, mesh)});
}

std::string name_of(const EdgePreset& preset) {
  return "edges kept, " + std::string(preset.name);
}

}  // namespace

Result<TriangleMesh> with_edges_kept(const TriangleMesh& noisy, const EdgeFilter& filter) {
  return filtered(noisy, {wave_of(noisy, kEdgeWaveEdges), SetEdges{filter}});
}

Result<EdgeFilter> proposed_filter(const TriangleMesh& noisy) {
  ASSIGN_OR_RETURN(const auto surface, make_denoise_surface(noisy));
  ASSIGN_OR_RETURN(const EdgeProposal proposal, propose_edges(*surface));
  return proposal.filter;
}

Status report_filtered(const NoisyShape& shape, BenchTable& table) {
  add(shape, "noisy", shape.clean, shape.noisy, table);
  for (const double waves : {6.0, kEdgeWaveEdges}) {
    ASSIGN_OR_RETURN(const TriangleMesh smooth,
                     filtered(shape.noisy, {wave_of(shape.noisy, waves), SetGradientScale{0}}));
    add(shape, "beta 0, waves of " + in_words("%g", waves) + " edges", shape.clean, smooth, table);
  }
  ASSIGN_OR_RETURN(const TriangleMesh kept, with_edges_kept(shape.noisy, shape.preset.filter));
  add(shape, name_of(shape.preset), shape.clean, kept, table);
  ASSIGN_OR_RETURN(const EdgeFilter proposal, proposed_filter(shape.noisy));
  ASSIGN_OR_RETURN(const TriangleMesh proposed, with_edges_kept(shape.noisy, proposal));
  add(shape, "edges kept, auto", shape.clean, proposed, table);
  return Status::ok();
}

Status report_sharpened(const NoisyShape& shape, BenchTable& table) {
  const SetTransferCurve wave = wave_of(shape.noisy, kEdgeWaveEdges);
  const SetGradientScale sharper{3};
  const SetEdges edges{shape.preset.filter};
  ASSIGN_OR_RETURN(const TriangleMesh aim, filtered(shape.clean, {wave, sharper}));
  ASSIGN_OR_RETURN(const TriangleMesh plain, filtered(shape.noisy, {wave, sharper}));
  ASSIGN_OR_RETURN(const TriangleMesh kept, filtered(shape.noisy, {wave, edges, sharper}));
  add(shape, "plain", aim, plain, table);
  add(shape, name_of(shape.preset), aim, kept, table);
  return Status::ok();
}

}  // namespace burnish
