#include "tests/server/prepare/pages/crack_finder.h"

#include <algorithm>
#include <bit>

namespace burnish {

namespace {

constexpr float kMoveSteps = 50;  // the most a vertex is moved along an axis

uint64_t mix(uint64_t bits) {
  bits = (bits ^ bits >> 31) * 0x9e3779b97f4a7c15;
  bits = (bits ^ bits >> 29) * 0xbf58476d1ce4e5b9;
  return bits ^ bits >> 32;
}

Vec3f moved(const Vec3i& position, uint32_t seed) {
  uint64_t bits = seed;
  for (int axis = 0; axis < 3; ++axis) bits = mix(bits + static_cast<uint32_t>(position[axis]));
  Vec3f place;
  for (int axis = 0; axis < 3; ++axis) {
    const auto part = static_cast<float>(bits >> (20 * axis) & 0xfffff) / 0x100000;
    place[axis] = static_cast<float>(position[axis]) + kMoveSteps * (part - 0.5f);
  }
  return place;
}

uint64_t hash_of_bits(const Vec3f& place) {
  uint64_t hash = 0;
  for (int axis = 0; axis < 3; ++axis) hash = mix(hash + std::bit_cast<uint32_t>(place[axis]));
  return hash;
}

}  // namespace

CrackFinder::CrackFinder(const ReadPages& read, uint32_t displacement_seed)
    : read_(read), level_boundaries_(read.level_count()) {
  for (const Page& page : read.pages) {
    add_page(page, displacement_seed);
    for (const Boundary& patch : patch_boundaries_.back())
      level_boundaries_[read.directory.head.level_of(page.id)].add(patch);
  }
}

uint32_t CrackFinder::number_of(const Vec3i& position, uint32_t seed) {
  const Vec3f place = moved(position, seed);
  auto& alike = places_[hash_of_bits(place)];
  for (const auto& [other, number] : alike)
    if (std::bit_cast<std::array<uint32_t, 3>>(std::array{place.x(), place.y(), place.z()}) ==
        std::bit_cast<std::array<uint32_t, 3>>(std::array{other.x(), other.y(), other.z()}))
      return number;
  alike.emplace_back(place, place_count_);
  return place_count_++;
}

void CrackFinder::add_page(const Page& page, uint32_t seed) {
  std::vector<uint32_t> numbers;
  for (const Vec3i& position : page.positions) numbers.push_back(number_of(position, seed));
  std::vector<Boundary>& patches = patch_boundaries_.emplace_back();
  auto triangle = page.triangles.begin();
  for (const PagePatch& patch : page.patches) {
    Boundary& boundary = patches.emplace_back();
    for (uint32_t i = 0; i < patch.triangles; ++i, ++triangle)
      boundary.add_triangle(
          {numbers[(*triangle)[0]], numbers[(*triangle)[1]], numbers[(*triangle)[2]]});
  }
}

size_t CrackFinder::count_cracks(const PageSet& cut) const {
  Boundary drawn;
  std::unordered_map<Boundary::Edge, uint64_t> levels_of_edge;  // a bit per level
  for (const Page& page : read_.pages) {
    if (!cut[page.id]) continue;
    for (size_t i = 0; i < page.patches.size(); ++i) {
      if (!is_drawn(page.patches[i], cut)) continue;
      drawn.add(patch_boundaries_[page.id][i]);
      const int level = read_.directory.head.level_of(page.id);
      for (const auto& edge : patch_boundaries_[page.id][i].edges())
        levels_of_edge[edge.first] |= uint64_t{1} << level;
    }
  }
  const auto is_crack = [&](const auto& edge) {
    for (int level = 0; level < read_.level_count(); ++level)
      if (levels_of_edge.at(edge.first) >> level & 1 &&
          level_boundaries_[level].at(edge.first) == edge.second)
        return false;
    return true;
  };
  return static_cast<size_t>(std::ranges::count_if(drawn.edges(), is_crack));
}

size_t CrackFinder::count_misfits() const {
  std::vector<Boundary> pages(read_.pages.size()), replacements(read_.pages.size());
  for (const Page& page : read_.pages)
    for (size_t i = 0; i < page.patches.size(); ++i) {
      const Boundary& patch = patch_boundaries_[page.id][i];
      pages[page.id].add(patch);
      if (page.patches[i].finer != kNoPage) replacements[page.patches[i].finer].add(patch);
    }
  size_t misfits = 0;
  for (PageId page = 0; page < read_.directory.head.root(); ++page)
    misfits += count_misfits(pages[page], replacements[page], read_.directory.head.level_of(page));
  return misfits;
}

size_t CrackFinder::count_misfits(const Boundary& page, const Boundary& replacement,
                                  int level) const {
  size_t misfits = 0;
  bool is_on_rim = false;
  for (const auto& [edge, passes] : page.edges()) {
    const bool is_rim = !level_boundaries_[level].at(edge).is_none();
    is_on_rim |= is_rim;
    misfits += !is_rim && replacement.at(edge) != passes;
  }
  if (is_on_rim) return misfits;
  for (const auto& [edge, passes] : replacement.edges()) misfits += page.at(edge).is_none();
  return misfits;
}

}  // namespace burnish
