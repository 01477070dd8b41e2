#include "server/process/disk_watch.h"

#include <algorithm>
#include <array>
#include <utility>

namespace burnish {

// A large scan takes gigabytes. Imports are refused below the third level, and edits when nothing
// is left.
static constexpr std::array<uint64_t, 5> kLevels = {uint64_t{8} << 30, uint64_t{1} << 30,
                                                    uint64_t{256} << 20, uint64_t{64} << 20,
                                                    uint64_t{8} << 20};

std::optional<uint64_t> DiskWatch::look(uint64_t free_bytes) {
  const auto below = static_cast<size_t>(
      std::ranges::count_if(kLevels, [&](uint64_t level) { return free_bytes < level; }));
  const size_t before = std::exchange(passed_, below);
  return below > before ? std::optional(kLevels[below - 1]) : std::nullopt;
}

}  // namespace burnish
