#include "server/prepare/pages/shared_vertices.h"

#include <algorithm>
#include <atomic>

namespace burnish {

namespace {

constexpr uint32_t kNoOwner = 0xffffffff;
constexpr uint32_t kSeveral = 0xfffffffe;

// Notes that a page has a vertex. The outcome does not depend on which page comes first.
void note(uint32_t page, uint32_t& owner_of_vertex) {
  const std::atomic_ref<uint32_t> owner(owner_of_vertex);
  uint32_t seen = owner.load(std::memory_order_relaxed);
  if (seen == page || seen == kSeveral) return;
  if (seen == kNoOwner && owner.compare_exchange_strong(seen, page, std::memory_order_relaxed))
    return;
  if (seen != page) owner.store(kSeveral, std::memory_order_relaxed);
}

}  // namespace

ScratchArray<uint8_t> find_shared_vertices(const CutLevel& level, const ScratchSpace& space,
                                           const LoopPart& part) {
  ScratchArray<uint32_t> owner(space, level.joined.size());
  std::ranges::fill(owner, kNoOwner);
  LoopProgress loop(part.progress, part.phase, part.begin, part.end);
#pragma omp parallel for schedule(dynamic, 16)
  for (size_t page = 0; page < level.pages.count(); ++page) {
    if (!loop.goes_on(0)) continue;
    for (const uint32_t t : level.pages[page])
      for (const uint32_t v : level.triangles[t])
        note(static_cast<uint32_t>(page), owner[level.joined[v]]);
  }
  leave_if_cancelled(loop);
  ScratchArray<uint8_t> shared(space, owner.size());
#pragma omp parallel for schedule(static)
  for (size_t v = 0; v < owner.size(); ++v) shared[v] = owner[v] == kSeveral;
  return shared;
}

}  // namespace burnish
