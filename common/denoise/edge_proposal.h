#pragma once

#include <cstdint>

#include "common/denoise/denoise.h"
#include "common/edit/proposed_edges.h"

namespace burnish {

/// Proposes a filter by the scan's own noise. A scan is machined if nearly all bends of its guided
/// normals are about right angles; then the preset for such parts is proposed. Other scans lose
/// detail by every pass, so they get as few as their noise needs, and a wider edge angle only where
/// noise turns normals that far. Fails: cancelled; resource_exhausted without memory.
Result<EdgeProposal> propose_edges(const DenoiseSurface& surface, const ScratchSpace& space = {},
                                   const Progress& progress = {});

/// Measures a scan's noise alone: its proposal is off and says nothing of edges. Needs: a valid
/// mesh. Cost: linear; 33 bytes a triangle and 44 a vertex while it runs. Fails: as
/// propose_edges().
Result<EdgeProposal> measure_noise(const MeshView& mesh, const ScratchSpace& space = {},
                                   const Progress& progress = {});

/// The bytes that a surface for denoising and propose_edges() take beside the mesh, at their peak.
struct ProposalBytes {
  uint64_t arrays = 0;  ///< in the scratch space
  uint64_t others = 0;
};

/// Predicts it for meshes whose vertices have six triangles on average.
ProposalBytes predict_proposal_bytes(const MeshView& mesh);
/// Predicts it for any mesh. Accuracy: no less than they take.
ProposalBytes predict_proposal_bytes(const DenoiseSurface& surface);

}  // namespace burnish
