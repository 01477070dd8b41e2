#include "common/mesh/vertex_welder.h"

#include <bit>
#include <random>

namespace burnish {

static constexpr uint32_t kEmpty = 0xFFFFFFFF;
static constexpr size_t kSlotsAtFirst = 1024;

VertexWelder::VertexWelder(std::vector<Vec3d>& vertices)
    : vertices_(vertices), slots_(kSlotsAtFirst, kEmpty) {
  // With secret seeds a hostile file cannot aim at one slot. The result does not depend on them.
  std::random_device random;
  for (uint64_t& seed : seeds_) seed = (uint64_t{random()} << 32) | random();
}

/// Returns the two halves of the full product, folded: every bit of both factors reaches the
/// result.
static uint64_t folded_product(uint64_t a, uint64_t b) {
  const auto product = static_cast<unsigned __int128>(a) * b;
  return static_cast<uint64_t>(product) ^ static_cast<uint64_t>(product >> 64);
}

size_t VertexWelder::slot_of(const Vec3d& position) const {
  const auto bits = [&](int axis) { return std::bit_cast<uint64_t>(position[axis]); };
  const uint64_t xy = folded_product(bits(0) ^ seeds_[0], bits(1) ^ seeds_[1]);
  const uint64_t hash = folded_product(xy ^ seeds_[2], bits(2) ^ seeds_[0]);
  const size_t mask = slots_.size() - 1;
  size_t slot = hash & mask;
  while (slots_[slot] != kEmpty && vertices_[slots_[slot]] != position) slot = (slot + 1) & mask;
  return slot;
}

uint32_t VertexWelder::index_of(const Vec3d& given) {
  const Vec3d position = given + Vec3d::Zero();  // turns -0 into 0
  const size_t slot = slot_of(position);
  if (slots_[slot] != kEmpty) return slots_[slot];
  const auto index = static_cast<uint32_t>(vertices_.size());
  slots_[slot] = index;
  vertices_.push_back(position);
  if (2 * vertices_.size() > slots_.size()) grow();
  return index;
}

void VertexWelder::grow() {
  slots_.assign(2 * slots_.size(), kEmpty);
  for (uint32_t v = 0; v < vertices_.size(); ++v) slots_[slot_of(vertices_[v])] = v;
}

}  // namespace burnish
