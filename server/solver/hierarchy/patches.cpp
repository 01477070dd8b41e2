#include "server/solver/hierarchy/patches.h"

#include <array>
#include <bit>

#include "server/solver/hierarchy/corner_sets.h"

namespace burnish {

namespace {

constexpr int64_t kEntriesPerCorner = 24;
constexpr int kColoursMax = 64;

using Corners = std::vector<int32_t>;

int64_t entries_of(const Corners& corners) {
  return static_cast<int64_t>(corners.size() * (corners.size() + 1) / 2);
}

// Gives a patch the least colour whose patches have no cell in common with it; 64 if there is none.
class Colours {
 public:
  explicit Colours(const SparseGrid& finest) : finest_(finest), of_cell_(finest.cells.size()) {}

  int take(const Corners& patch) {
    uint64_t taken = 0;
    for_each_cell_around(finest_, patch, [&](int32_t cell) { taken |= of_cell_[cell]; });
    const int colour = std::countr_one(taken);
    if (colour < kColoursMax)
      for_each_cell_around(finest_, patch, [&](int32_t cell) { of_cell_[cell] |= 1ull << colour; });
    return colour;
  }

 private:
  const SparseGrid& finest_;
  std::vector<uint64_t> of_cell_;
};

void append(const Corners& patch, Patches& patches) {
  patches.corner.insert(patches.corner.end(), patch.begin(), patch.end());
  patches.start.push_back(static_cast<int32_t>(patches.corner.size()));
  patches.entry_start.push_back(patches.entry_count() + entries_of(patch));
}

}  // namespace

std::vector<Corners> Patches::corner_sets() const {
  std::vector<Corners> sets;
  for (int32_t p = 0; p < count(); ++p)
    sets.emplace_back(corner.begin() + start[p], corner.begin() + start[p + 1]);
  return sets;
}

uint64_t Patches::byte_count() const {
  return (start.capacity() + corner.capacity() + colour_start.capacity()) * sizeof(int32_t) +
         entry_start.capacity() * sizeof(int64_t);
}

Patches make_patches(const SparseGrid& finest, std::span<const Corners> sets,
                     std::vector<char>* was_left_out) {
  Colours colours(finest);
  if (was_left_out != nullptr) was_left_out->assign(sets.size(), 1);
  std::array<std::vector<const Corners*>, kColoursMax + 1> by_colour;
  int64_t entries_left = kEntriesPerCorner * finest.corner_count();
  for (const Corners& set : sets) {
    if (entries_of(set) > entries_left) continue;
    entries_left -= entries_of(set);
    const int colour = colours.take(set);
    by_colour[colour].push_back(&set);
    if (was_left_out != nullptr && colour < kColoursMax) (*was_left_out)[&set - sets.data()] = 0;
  }
  Patches patches;
  for (int colour = 0; colour < kColoursMax && !by_colour[colour].empty(); ++colour) {
    for (const Corners* set : by_colour[colour]) append(*set, patches);
    patches.colour_start.push_back(patches.count());
  }
  return patches;
}

}  // namespace burnish
