#include "server/prepare/pages/replace_pages.h"

#include <algorithm>
#include <numeric>

#include "server/prepare/pages/simplify_piece.h"

namespace burnish {

namespace {

// In units of meshoptimizer's error. On all levels of five scans 99 of 100 vertices of the scan
// itself lie within this of the simplified surface, and on most levels 999 of 1,000 do. Small
// components that vanish were farther away.
constexpr float kErrorFactor = 1.5f;

/// Holds a page as one thread makes it.
struct MadePage {
  std::vector<Triangle> triangles;
  float error = 0;
};

/// The pages of one level on their way.
class Replacer {
 public:
  Replacer(const CutLevel& level, const PageVertices& vertices, std::span<const uint8_t> shared,
           Replacements& made)
      : level_(level), vertices_(vertices), shared_(shared), made_(made) {
    made_.of_pages.resize(level.pages.count());
  }

  Status replace_all(SimplifyBy by, const PageWork& work) {
    std::vector<size_t> all(made_.of_pages.size());
    std::iota(all.begin(), all.end(), 0);
    return replace(all, by, work);
  }

  /// Replaces these pages. Fails: cancelled.
  Status replace(std::span<const size_t> pages, SimplifyBy by, const PageWork& work) {
    std::vector<MadePage> batch(std::min(pages.size(), PageWork::kPagesPerBatch));
    return work.run(
        pages.size(), [&](size_t i) { batch[i % batch.size()] = make(pages[i], by); },
        [&](size_t i) {
          const MadePage& page = batch[i % batch.size()];
          made_.of_pages[pages[i]] = {made_.triangles.size(), page.triangles.size(), page.error};
          made_.triangles.append(page.triangles);
          return Status::ok();
        });
  }

  bool hardly_shrinks(size_t page) const {
    return static_cast<double>(made_.of_pages[page].count) >
           kLevelShrinkMax * static_cast<double>(level_.pages[page].size());
  }

  bool is_small_enough() const {
    uint64_t left = 0;
    for (const Replacement& replacement : made_.of_pages) left += replacement.count;
    return static_cast<double>(left) <=
           kLevelShrinkMax * static_cast<double>(level_.triangles.size());
  }

 private:
  MadePage make(size_t page, SimplifyBy by) const {
    const PagePiece piece = make_piece(level_, vertices_.positions, shared_, page);
    // A page without any area stays in sight of the coarser levels: each page must be replaced.
    if (piece.triangles.empty()) return {{level_.triangles[level_.pages[page][0]]}};
    const SimplePiece simple = simplify_piece(piece, by);
    MadePage made;
    made.error = kErrorFactor * simple.error * static_cast<float>(vertices_.grid.step());
    made.triangles.reserve(simple.triangles.size());
    for (const Triangle& t : simple.triangles)
      made.triangles.push_back({piece.vertices[t[0]], piece.vertices[t[1]], piece.vertices[t[2]]});
    return made;
  }

  const CutLevel& level_;
  const PageVertices& vertices_;
  std::span<const uint8_t> shared_;
  Replacements& made_;
};

}  // namespace

Result<Replacements> keep_pages(const CutLevel& level, const PageVertices& vertices,
                                std::span<const uint8_t> shared, const ScratchSpace& space,
                                const PageWork& work) {
  Replacements made(space);
  RETURN_IF_ERROR(Replacer(level, vertices, shared, made).replace_all(SimplifyBy::kKeep, work));
  return made;
}

Result<Replacements> replace_pages(const CutLevel& level, const PageVertices& vertices,
                                   std::span<const uint8_t> shared, const ScratchSpace& space,
                                   const PageWork& work) {
  Replacements made(space);
  Replacer replacer(level, vertices, shared, made);
  RETURN_IF_ERROR(replacer.replace_all(SimplifyBy::kCollapse, work));
  for (const SimplifyBy by : {SimplifyBy::kCollapseMore, SimplifyBy::kCluster, SimplifyBy::kDrop}) {
    if (replacer.is_small_enough()) break;
    std::vector<size_t> stuck;
    for (size_t page = 0; page < made.of_pages.size(); ++page)
      if (replacer.hardly_shrinks(page)) stuck.push_back(page);
    RETURN_IF_ERROR(replacer.replace(stuck, by, work));
    if (by == SimplifyBy::kCluster) made.clustered_pages += stuck.size();
    if (by == SimplifyBy::kDrop) made.torn_pages += stuck.size();
  }
  return made;
}

}  // namespace burnish
