#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace burnish {

/// Costs and results of making pages.
struct PagesReport {
  struct Level {
    uint64_t triangles = 0;
    uint64_t pages = 0;
    uint64_t vertices = 0;         ///< of all pages, so shared ones count several times
    uint64_t border_vertices = 0;  ///< of these, those that several pages have
    uint64_t bytes = 0;            ///< of the encoded pages
    uint64_t clustered_pages = 0;  ///< that edge collapses could not simplify
    uint64_t torn_pages = 0;       ///< that clustering could not simplify: gaps may open at them
  };
  struct Phase {
    std::string name;
    double seconds = 0;
  };
  std::vector<Level> levels;  ///< the finest first
  std::vector<Phase> phases;  ///< over all levels
};

}  // namespace burnish
