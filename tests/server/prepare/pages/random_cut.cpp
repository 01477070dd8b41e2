#include "tests/server/prepare/pages/random_cut.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "tests/common/pages/legal_cut.h"

namespace burnish {

namespace {

using Random = std::mt19937;

PageSet any_pages(const PageDirectory& directory, Random& random) {
  PageSet cut(directory.entries.size());
  const double chance = std::pow(10.0, -3 * std::generate_canonical<double, 32>(random));
  for (uint8_t& page : cut) page = std::generate_canonical<double, 32>(random) < chance;
  cut.back() = 1;
  close_cut(directory, cut);
  return cut;
}

PageSet detail_around_place(const PageDirectory& directory, Random& random) {
  PageSet cut(directory.entries.size());
  const Vec3f place = directory.entries[random() % cut.size()].bounds.centre;
  const float sharpness = std::pow(10.0f, 2 - 4 * std::generate_canonical<float, 24>(random));
  for (size_t page = 0; page < cut.size(); ++page) {
    const PageBounds& bounds = directory.entries[page].bounds;
    cut[page] = (bounds.centre - place).norm() - bounds.radius < bounds.edge * sharpness;
  }
  cut.back() = 1;
  close_cut(directory, cut);
  return cut;
}

PageSet pages_so_far(const PageDirectory& directory, Random& random) {
  PageSet cut(directory.entries.size());
  cut.back() = 1;
  std::vector<PageId> order(cut.size());
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), random);
  const size_t pages_max = 1 + random() % cut.size();
  size_t pages = 1;
  for (bool has_grown = true; has_grown;) {
    has_grown = false;
    for (const PageId page : order) {
      const auto is_there = [&](PageId coarser) { return cut[coarser] != 0; };
      if (cut[page] || pages == pages_max) continue;
      if (!std::ranges::all_of(directory.coarser[page], is_there)) continue;
      cut[page] = 1;
      ++pages;
      has_grown = true;
    }
  }
  return cut;
}

}  // namespace

PageSet random_legal_cut(const PageDirectory& directory, uint32_t seed) {
  Random random(seed);
  switch (seed % 3) {
    case 0:
      return any_pages(directory, random);
    case 1:
      return detail_around_place(directory, random);
    default:
      return pages_so_far(directory, random);
  }
}

}  // namespace burnish
