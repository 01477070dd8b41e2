// Kept edges in frames: the layer of vertices, which corners cannot carry.

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/evaluation/displacement_steps.h"
#include "common/generate/generate.h"
#include "tests/server/live/live_work.h"

namespace burnish {
namespace {

using enum PageFrameKind;

constexpr int kDepthOfPart = 6;

SetEdges machined(double strength = 1) {
  SetEdges edges{find_edge_preset("machined")->filter};
  edges.filter.strength = strength;
  return edges;
}

/// Ann's session "part" on a noisy machined part.
class KeptEdgesInFrames : public LiveWork {
 protected:
  KeptEdgesInFrames() : noisy_(*generate_scan({"part", 4000, 1, 0.2, *parse_noise_kind("gauss")})) {
    BURNISH_CHECK(library_.import(mesh_file(noisy_), "part", {}, kDepthOfPart).is_ok(), "import");
    BURNISH_CHECK(manager_->open({"part", "part", {kDepthOfPart, 0}}, "ann", {}).is_ok(), "open");
  }

  LiveGuest ann_at_level(int level, std::optional<PageFrameKind> kind = std::nullopt) {
    LiveGuest ann = guest("ann", {"part", kind});
    ann.show_level(level);
    ann.settle();
    return ann;
  }
  static void edit(LiveGuest& guest, const Change& change) {
    static int number = 0;
    guest.edit({{"e" + std::to_string(++number), change}});
    guest.subscriber().grant({.frames = 1});
    guest.settle();
  }

  /// Returns the places of an exact export. Frames show what it has relaxed.
  std::vector<Vec3d> exported() {
    EXPECT_TRUE(
        manager_->export_mesh("part", {.format = MeshFormat::kPly, .exact = true}, {}).is_ok());
    std::vector<Vec3d> places;
    const auto look = [&](Session& session) {
      places = session.surface().vertices;
      return Status::ok();
    };
    EXPECT_TRUE(manager_->visit("part", {}, look).is_ok());
    return places;
  }

  /// Returns how far a frame's vertices are from those of a surface, cells, on the scan's level.
  double off(const LiveGuest& guest, const std::vector<Vec3d>& surface) {
    const auto mesh = manager_->attach("part", {}).value().mesh;
    const double cell = mesh->prepared->frame.cell_size;
    const PageGrid& lattice = guest.pages.head().grid;
    double worst = 0;
    for (const PageTile& tile : guest.pages.state().tiles) {
      const Page page = guest.pages.page(tile.shown.page);
      std::vector<Vec3f> moved(page.positions.size());
      tile.read_displacements(moved);
      for (size_t v = 0; v < moved.size(); ++v) {
        const size_t of_scan = nearest(lattice.to_file(page.positions[v]));
        const Vec3d wanted = (surface[of_scan] - noisy_.vertices[of_scan]) / cell;
        worst = std::max(worst, (moved[v].cast<double>() - wanted).norm());
      }
    }
    return worst;
  }
  size_t nearest(const Vec3d& place) const {
    const auto distance = [&](const Vec3d& vertex) { return (vertex - place).squaredNorm(); };
    return std::ranges::min_element(noisy_.vertices, {}, distance) - noisy_.vertices.begin();
  }

  const TriangleMesh noisy_;
};

TEST_F(KeptEdgesInFrames, ShowWhatAnExportWrites) {
  LiveGuest ann = ann_at_level(0);
  edit(ann, machined());
  EXPECT_EQ(ann.pages.kind(), kVertices);
  const std::vector<Vec3d> surface = exported();
  EXPECT_GT(off(ann, noisy_.vertices), 0.2);
  ann.subscriber().grant({.frames = 1});
  ann.settle();
  EXPECT_TRUE(ann.all<LiveFrame>().back().stats.exact);
  EXPECT_LT(off(ann, surface), 2.0 / kStepsPerCell);
}

TEST_F(KeptEdgesInFrames, StayWithinTheCap) {
  LiveGuest ann = ann_at_level(0);
  edit(ann, machined());
  const auto cell = manager_->attach("part", {}).value().mesh->prepared->frame.cell_size;
  edit(ann, SetControls{{.cap = 0.05 * cell}});
  EXPECT_LT(off(ann, noisy_.vertices), 0.05 + 1.0 / kStepsPerCell);
  EXPECT_GT(off(ann, noisy_.vertices), 0.04);
  exported();
  ann.subscriber().grant({.frames = 1});
  ann.settle();
  EXPECT_LT(off(ann, exported()), 2.0 / kStepsPerCell);
}

TEST_F(KeptEdgesInFrames, MoveCoarseLevelsToo) {
  LiveGuest ann = guest("ann", {"part"});
  ASSERT_GT(ann.pages.head().level_pages.size(), 1u);
  ann.show_level(static_cast<int>(ann.pages.head().level_pages.size()) - 1);
  ann.settle();
  EXPECT_THAT(ann.pages.values(), testing::Each(0));
  edit(ann, machined());
  std::vector<int32_t> sizes = ann.pages.values();
  for (int32_t& value : sizes) value = std::abs(value);
  std::ranges::sort(sizes);
  EXPECT_GT(sizes[sizes.size() / 4 * 3], 6);
}

TEST_F(KeptEdgesInFrames, ComeByVerticesWhileThereIsALayer) {
  LiveGuest ann = ann_at_level(0);
  const PageFrameKind before = ann.pages.kind();
  edit(ann, machined());
  EXPECT_EQ(ann.pages.kind(), kVertices);
  edit(ann, machined(0));
  const std::vector<Vec3d> surface = exported();
  ann.subscriber().grant({.frames = 1});
  ann.settle();
  if (before == kVertices) {
    EXPECT_LT(off(ann, surface), 2.0 / kStepsPerCell);
  }
  EXPECT_THAT(ann.pages.values(), testing::Each(testing::AllOf(testing::Ge(-1), testing::Le(1))));
}

TEST_F(KeptEdgesInFrames, AreNotExactForAClientThatInsistsOnCorners) {
  LiveGuest ann = ann_at_level(0, kCorners);
  edit(ann, machined());
  exported();
  ann.subscriber().grant({.frames = 1});
  ann.settle();
  EXPECT_EQ(ann.pages.kind(), kCorners);
  EXPECT_TRUE(ann.all<LiveFrame>().back().stats.settled);
  EXPECT_FALSE(ann.all<LiveFrame>().back().stats.exact);
}

TEST_F(KeptEdgesInFrames, AreThereForOneWhoComesLater) {
  LiveGuest ann = ann_at_level(0);
  edit(ann, machined());
  LiveGuest bob = guest("bob", {"part"});
  bob.show_level(0);
  bob.settle();
  EXPECT_EQ(bob.pages.values(), ann.pages.values());
}

TEST_F(KeptEdgesInFrames, GoWithAnUndoAndComeBackWithARedo) {
  LiveGuest ann = ann_at_level(0);
  edit(ann, machined());
  const std::vector<int32_t> kept = ann.pages.values();
  edit(ann, Undo{});
  EXPECT_LT(off(ann, noisy_.vertices), 2.0 / kStepsPerCell);
  EXPECT_EQ(ann.all<HistoryState>().back().settings.edges, EdgeFilter());
  edit(ann, Redo{});
  ASSERT_EQ(ann.pages.values().size(), kept.size());
  int worst = 0;
  for (size_t i = 0; i < kept.size(); ++i)
    worst = std::max(worst, std::abs(kept[i] - ann.pages.values()[i]));
  EXPECT_LE(worst, 1);
}

}  // namespace
}  // namespace burnish
