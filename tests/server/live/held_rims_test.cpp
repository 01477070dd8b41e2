// Vertices on held rims, in frames.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/generate/generate.h"
#include "common/page_frames/page_corners.h"
#include "tests/common/odd_triangles.h"
#include "tests/server/live/live_work.h"

namespace burnish {
namespace {

using enum PageFrameKind;

constexpr int kDepth = 5;

/// Ann's session "sheet" on an open sheet of several pages and levels, smoothed. A new session
/// holds its rim.
class HeldRimsInFrames : public LiveWork, public testing::WithParamInterface<PageFrameKind> {
 protected:
  HeldRimsInFrames() { open("sheet", make_sheet(60, 1, 0.1)); }

  void open(const std::string& name, const TriangleMesh& mesh) {
    BURNISH_CHECK(library_.import(mesh_file(mesh), name).is_ok(), "import");
    BURNISH_CHECK(manager_->open({name, name, {kDepth, 0}}, "ann", {}).is_ok(), "open");
  }

  static void smooth(LiveGuest& guest) {
    for (size_t level = 0; level < guest.pages.head().level_pages.size(); ++level)
      guest.show_level(static_cast<int>(level));
    guest.edit({{"a", SetTransferCurve{TransferCurve(10)}}, {"b", SetGradientScale{0}}});
    guest.settle();
  }
  static void hold(LiveGuest& guest, bool pin_rims, const std::string& id) {
    guest.edit({{id, SetControls{{.pin_rims = pin_rims}}}});
    guest.settle();
  }

  /// Returns the displacement of a page's vertices, as docs/protocol.md says.
  static std::vector<Vec3f> displaced(const LiveGuest& guest, const PageTile& tile) {
    const Page page = guest.pages.page(tile.shown.page);
    std::vector<Vec3f> values(tile.shown.value_count()), moved(page.positions.size());
    tile.read_displacements(values);
    const int bits = guest.pages.head().grid.bits;
    if (guest.pages.kind() == kVertices)
      moved = values;
    else
      evaluate_page(make_page_corners(page.positions, bits, kDepth), page.positions, bits, kDepth,
                    values, moved);
    for_each_held(tile.held, [&](size_t vertex) { moved[vertex].setZero(); });
    return moved;
  }

  struct Moves {
    size_t rim_vertices = 0;  // of all pages
    size_t still = 0;         // of these
    float rim = 0, inside = 0;
  };
  static Moves moves_of(const LiveGuest& guest, PageId begin, PageId end) {
    Moves moves;
    const PageGrid& lattice = guest.pages.head().grid;
    for (PageId number = begin; number < end; ++number) {
      const Page page = guest.pages.page(number);
      const auto moved = displaced(guest, *guest.pages.state().find(number));
      for (size_t v = 0; v < moved.size(); ++v) {
        const Vec3d at = lattice.to_file(page.positions[v]);
        const double inward = std::min({at.x(), at.y(), 1 - at.x(), 1 - at.y()});
        const bool is_rim = inward < lattice.step();
        moves.rim_vertices += is_rim;
        moves.still += is_rim && moved[v].isZero(0);
        float& most = is_rim ? moves.rim : moves.inside;
        most = std::max(most, moved[v].norm());
      }
    }
    return moves;
  }
};

INSTANTIATE_TEST_SUITE_P(Kinds, HeldRimsInFrames, testing::Values(kVertices, kCorners));

TEST_P(HeldRimsInFrames, AreAtTheirPlaceOnAllLevels) {
  LiveGuest ann = guest("ann", {"sheet", GetParam()});
  smooth(ann);
  const PageHead& head = ann.pages.head();
  ASSERT_GT(head.level_pages.size(), 1u);
  for (size_t level = 0; level < head.level_pages.size(); ++level) {
    const PageId begin = head.level_begin(static_cast<int>(level));
    const Moves moves = moves_of(ann, begin, begin + head.level_pages[level]);
    EXPECT_GT(moves.rim_vertices, 8u) << level;
    EXPECT_EQ(moves.still, moves.rim_vertices) << level;
    EXPECT_EQ(moves.rim, 0) << level;
    EXPECT_GT(moves.inside, 0.5F) << level;
  }
}

TEST_P(HeldRimsInFrames, AreAtTheirPlaceWhateverTrianglesAreNoSurface) {
  for (const auto& [name, mesh] : with_triangles_of_no_surface(make_sheet(60, 1, 0.1))) {
    open(name, mesh);
    LiveGuest ann = guest("ann", {name, GetParam()});
    smooth(ann);
    const Moves moves = moves_of(ann, 0, ann.pages.head().level_pages[0]);
    EXPECT_EQ(moves.rim, 0) << name;
    EXPECT_GT(moves.inside, 0.5F) << name;
  }
}

TEST_P(HeldRimsInFrames, MoveWhileTheControlsLeaveThemFree) {
  LiveGuest ann = guest("ann", {"sheet", GetParam()});
  smooth(ann);
  const PageId pages = ann.pages.head().level_pages[0];
  hold(ann, false, "c");
  const Moves free = moves_of(ann, 0, pages);
  EXPECT_GT(free.rim, 0.5F);
  EXPECT_LT(free.still, free.rim_vertices / 10);
  hold(ann, true, "d");
  EXPECT_EQ(moves_of(ann, 0, pages).rim, 0);
}

TEST_P(HeldRimsInFrames, AreNamedToClientsThatKnowThem) {
  LiveGuest ann = guest("ann", {"sheet", GetParam()});
  smooth(ann);
  LiveGuest old = guest("ann", {"sheet", GetParam(), false});
  smooth(old);
  size_t named = 0, named_to_old = 0;
  for (const PageTile& tile : ann.pages.state().tiles) named += tile.held ? 1 : 0;
  for (const PageTile& tile : old.pages.state().tiles) named_to_old += tile.held ? 1 : 0;
  EXPECT_EQ(named > 0, GetParam() == kCorners);
  EXPECT_EQ(named_to_old, 0u);
  const Moves without = moves_of(old, 0, old.pages.head().level_pages[0]);
  EXPECT_EQ(without.rim > 0, GetParam() == kCorners);
  EXPECT_LT(without.rim, 0.1F);
}

}  // namespace
}  // namespace burnish
