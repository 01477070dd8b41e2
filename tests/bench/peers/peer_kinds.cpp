#include "tests/bench/peers/peer.h"

namespace burnish::bench {

#ifdef BURNISH_BENCH_CHOLMOD
static constexpr auto kCholmod = make_cholmod;
#else
static constexpr auto kCholmod = nullptr;
#endif
#ifdef BURNISH_BENCH_HYPRE
static constexpr auto kHypre = make_hypre;
#else
static constexpr auto kHypre = nullptr;
#endif

// Direct peers come first: the others are compared with their answers.
static constexpr PeerKind kPeers[] = {
    {"CHOLMOD", false, true, kCholmod},
    {"Eigen LDLT", false, false, make_eigen_ldlt},
    {"Eigen CG diagonal", true, true, make_eigen_cg_diagonal},
    {"Eigen CG incomplete", true, true, make_eigen_cg_incomplete},
    {"hypre AMG-CG", true, false, kHypre},
};

std::span<const PeerKind> peer_kinds() {
  return kPeers;
}

}  // namespace burnish::bench
