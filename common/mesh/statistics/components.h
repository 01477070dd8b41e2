#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/base/heard_loop.h"
#include "common/base/types.h"

namespace burnish {

/// Returns for each vertex the least vertex of its component; components are connected through
/// edges. Cost: near linear time.
std::vector<int32_t> component_roots(std::span<const Triangle> triangles, size_t vertices);

/// Puts the same into an array with an entry for each vertex. Throws: WorkCancelled.
void find_component_roots(std::span<const Triangle> triangles, std::span<int32_t> roots,
                          const LoopPart& part = kUnheardLoop);

}  // namespace burnish
