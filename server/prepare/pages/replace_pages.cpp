#include "server/prepare/pages/replace_pages.h"

#include "server/prepare/pages/simplify_piece.h"

namespace burnish {

namespace {

// In units of meshoptimizer's error. On all levels of five scans 99 of 100 vertices of the scan
// itself lie within this of the simplified surface, and on most levels 999 of 1,000 do. Crumbs that
// vanish were farther away.
constexpr float kErrorFactor = 1.5f;

/// The pages of one level on their way.
class Replacer {
 public:
  Replacer(const CutLevel& level, const PageVertices& vertices, std::span<const uint8_t> shared)
      : level_(level), vertices_(vertices), shared_(shared) {}

  Replacement replace(size_t page, SimplifyBy by) const {
    const PagePiece piece = make_piece(level_, vertices_.positions, shared_, page);
    // A page without any area stays in sight of the coarser levels: each page must be replaced.
    if (piece.triangles.empty()) return {{level_.triangles[level_.pages[page][0]]}};
    const SimplePiece simple = simplify_piece(piece, by);
    Replacement made;
    made.error = kErrorFactor * simple.error * static_cast<float>(vertices_.grid.step());
    made.triangles.reserve(simple.triangles.size());
    for (const Triangle& t : simple.triangles)
      made.triangles.push_back({piece.vertices[t[0]], piece.vertices[t[1]], piece.vertices[t[2]]});
    return made;
  }

  bool hardly_shrinks(size_t page, const Replacement& made) const {
    return static_cast<double>(made.triangles.size()) >
           kLevelShrinkMax * static_cast<double>(level_.pages[page].size());
  }

 private:
  const CutLevel& level_;
  const PageVertices& vertices_;
  std::span<const uint8_t> shared_;
};

bool is_small_enough(const std::vector<Replacement>& made, size_t triangles) {
  size_t left = 0;
  for (const Replacement& replacement : made) left += replacement.triangles.size();
  return static_cast<double>(left) <= kLevelShrinkMax * static_cast<double>(triangles);
}

}  // namespace

Result<Replacements> replace_pages(const CutLevel& level, const PageVertices& vertices,
                                   std::span<const uint8_t> shared, const PageWork& work) {
  const Replacer replacer(level, vertices, shared);
  Replacements made;
  made.of_pages.resize(level.pages.count());
  RETURN_IF_ERROR(work.run(made.of_pages.size(), [&](size_t page) {
    made.of_pages[page] = replacer.replace(page, SimplifyBy::kCollapse);
  }));
  for (const SimplifyBy by : {SimplifyBy::kCollapseMore, SimplifyBy::kCluster, SimplifyBy::kDrop}) {
    if (is_small_enough(made.of_pages, level.triangles.size())) break;
    std::vector<size_t> stuck;
    for (size_t page = 0; page < made.of_pages.size(); ++page)
      if (replacer.hardly_shrinks(page, made.of_pages[page])) stuck.push_back(page);
    RETURN_IF_ERROR(work.run(
        stuck.size(), [&](size_t i) { made.of_pages[stuck[i]] = replacer.replace(stuck[i], by); }));
    if (by == SimplifyBy::kCluster) made.clustered_pages += stuck.size();
    if (by == SimplifyBy::kDrop) made.torn_pages += stuck.size();
  }
  return made;
}

}  // namespace burnish
