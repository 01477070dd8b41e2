// The part of MeshStore that measures the noise of scans.

#include <algorithm>

#include "common/base/parallel.h"
#include "common/denoise/edge_proposal.h"
#include "server/library/mesh_store.h"
#include "server/library/read_original.h"
#include "server/memory/library_budget.h"
#include "server/scheduling/cancellable_lock.h"

namespace burnish {

static PreparationNeed need_of(const StoredMesh& mesh, const ProposalBytes& bytes,
                               const ScratchSpace& space) {
  const uint64_t scan =
      mesh.vertices.size() * (sizeof(Vec3d) + (mesh.colours.empty() ? 0 : sizeof(Rgba8))) +
      mesh.triangles.size() * sizeof(Triangle);
  const uint64_t arrays = scan + bytes.arrays;
  const uint64_t in_memory = std::min(arrays, space.memory_bytes_max());
  PreparationNeed need;
  need.memory_bytes = in_memory + bytes.others;
  need.scratch_bytes = arrays - in_memory;
  return need;
}

// A scan whose vertices have many triangles takes more than was predicted before its rings are
// known.
Result<EdgeProposal> MeshStore::measure_noise(const std::string& id, const Progress& progress) {
  ASSIGN_OR_RETURN(const OriginalFile original, find_original(id, progress));
  LibraryBudget budget(memory_, folder_.scans());
  RETURN_IF_ERROR(budget.ask_to_read(original.path, original.format));
  ASSIGN_OR_RETURN(const auto mesh,
                   read_original(original.path, original.format, original.name, budget, progress));
  use_threads(options_.threads);
  const MeshView view = mesh->view();
  RETURN_IF_ERROR(budget.ask(need_of(*mesh, predict_proposal_bytes(view), budget.space())));
  ASSIGN_OR_RETURN(const auto surface, make_denoise_surface(view, budget.space(), progress));
  RETURN_IF_ERROR(budget.ask(need_of(*mesh, predict_proposal_bytes(*surface), budget.space())));
  return burnish::propose_edges(*surface, budget.space(), progress);
}

// Locks only this work: opening and importing other scans go on.
Result<EdgeProposal> MeshStore::propose_edges(const std::string& id, const Progress& progress) {
  if (const auto known = proposals_.find(id)) return *known;
  ASSIGN_OR_RETURN(const auto lock,
                   lock_or_cancel(measuring_, "waiting for another scan", progress));
  if (const auto known = proposals_.find(id)) return *known;
  auto proposal = measure_noise(id, progress);
  if (!proposal.is_ok()) return proposal.status().with_context("measuring the noise");
  proposals_.add(id, *proposal);
  return proposal;
}

}  // namespace burnish
