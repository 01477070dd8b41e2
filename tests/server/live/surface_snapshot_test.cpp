#include "server/live/surface_snapshot.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/server/manager/test_library.h"

namespace burnish {
namespace {

/// A sphere of several pages at depth 5, and clients that show some of them.
class SurfaceSnapshotTest : public testing::Test {
 protected:
  SurfaceSnapshotTest() {
    const std::string id = library_.import(sphere_file(1, 5), "ball").value().scan.id;
    MeshStore& store = *library_.store;
    mesh_ = store.open_mesh(id, {5, 0}, {}).value();
    source_ = std::make_unique<ScanPageSource>(store, store.open_pages(id, {}).value(), mesh_);
    displacement_.assign(grid().corners.size(), Vec3f(0.25F, 0, 0));
    beta_.assign(grid().cells.size(), 1);
  }
  const SparseGrid& grid() const { return mesh_->hierarchy->at(mesh_->hierarchy->finest).grid; }
  std::shared_ptr<const ClientPages> client(const std::vector<PageId>& numbers) {
    ClientPages made;
    made.pages = source_->find_or_make(numbers, PageFrameKind::kVertices).value();
    return std::make_shared<const ClientPages>(made);
  }
  /// The same, with white pages of colours.
  std::shared_ptr<const ClientPages> white_client(const std::vector<PageId>& numbers) {
    ClientPages made = *client(numbers);
    for (auto& page : made.pages) {
      if (!is_colours(page->number())) continue;
      auto white = std::make_shared<LivePage>();
      white->evaluation = page->evaluation;
      white->cells = page->cells;
      white->colours.assign(white->evaluation.points.size(), Rgba8{255, 255, 255, 255});
      page = std::move(white);
    }
    return std::make_shared<const ClientPages>(std::move(made));
  }
  SurfaceMoment moment(bool settled = true) const {
    return {grid(), mesh_->prepared->evaluation, displacement_, beta_, settled};
  }

  TestLibrary library_;
  std::shared_ptr<const SharedMesh> mesh_;
  std::unique_ptr<ScanPageSource> source_;
  std::vector<Vec3f> displacement_;
  std::vector<float> beta_;
};

TEST_F(SurfaceSnapshotTest, ClientsShareThePagesThatBothShow) {
  const std::shared_ptr<const ClientPages> clients[] = {client({0, 1}), client({1, 2})};
  const SurfaceSnapshot snapshot = SurfaceSnapshot::take(moment(), clients).value();
  const auto first = snapshot.wanted(*clients[0]), second = snapshot.wanted(*clients[1]);
  EXPECT_EQ(first[1].steps.data(), second[0].steps.data());
  EXPECT_NE(first[0].steps.data(), second[1].steps.data());
  EXPECT_EQ(first[0].steps[0], 64);
}

TEST_F(SurfaceSnapshotTest, ThePagesOfTheLastSnapshotAreNotDoneAgain) {
  const std::shared_ptr<const ClientPages> before[] = {client({0, 1})};
  const std::shared_ptr<const ClientPages> after[] = {client({1, 2})};
  const SurfaceSnapshot last = SurfaceSnapshot::take(moment(), before).value();
  SurfaceMoment same = moment();
  same.last = &last;
  const SurfaceSnapshot snapshot = SurfaceSnapshot::take(same, after).value();
  EXPECT_EQ(snapshot.wanted(*after[0])[0].steps.data(), last.wanted(*before[0])[1].steps.data());
  EXPECT_EQ(snapshot.wanted(*after[0])[1].steps[0], 64);
  EXPECT_EQ(snapshot.largest_move(), last.largest_move());
}

TEST_F(SurfaceSnapshotTest, ColoursArePagesOfTheirOwn) {
  const std::shared_ptr<const ClientPages> clients[] = {client({1, 1 | kColourPages})};
  EXPECT_THAT(SurfaceSnapshot::take(moment(), clients)->wanted(*clients[0])[1].steps,
              testing::Each(0));
  const std::vector<Vec3f> red(displacement_.size(), Vec3f(0.5F, 0, 0));
  SurfaceMoment coloured = moment();
  coloured.colour.on_grid = red;
  const SurfaceSnapshot snapshot = SurfaceSnapshot::take(coloured, clients).value();
  EXPECT_EQ(snapshot.wanted(*clients[0])[0].steps[0], 64);
  EXPECT_EQ(snapshot.wanted(*clients[0])[1].steps[0], 0.5 * 16 * 256);
  EXPECT_EQ(snapshot.wanted(*clients[0])[1].steps.back(), 0);
  EXPECT_FLOAT_EQ(snapshot.largest_move(), 0.25F);
}

// The page is white, the fitted colours are black, so the cells' share is added whole.
TEST_F(SurfaceSnapshotTest, DetailsOfColoursComeFromTheVertexItself) {
  const std::shared_ptr<const ClientPages> clients[] = {white_client({1, 1 | kColourPages})};
  const std::vector<Vec3f> red(displacement_.size(), Vec3f(0.5F, 0, 0)),
      black(displacement_.size(), Vec3f::Zero());
  const std::vector<float> share(grid().cells.size(), -0.25F);
  SurfaceMoment coloured = moment();
  coloured.colour = {red, black, share};
  const SurfaceSnapshot snapshot = SurfaceSnapshot::take(coloured, clients).value();
  EXPECT_EQ(snapshot.wanted(*clients[0])[1].steps[0], 0.25 * 16 * 256);
  EXPECT_EQ(snapshot.wanted(*clients[0])[1].steps.back(), -0.25 * 16 * 256);
}

TEST_F(SurfaceSnapshotTest, AGainOfTexelsIsAPageOfItsOwn) {
  const std::shared_ptr<const ClientPages> clients[] = {
      white_client({1, 1 | kColourPages, 1 | kGainPages})};
  const std::vector<Vec3f> grey(displacement_.size(), Vec3f::Constant(0.75F));
  SurfaceMoment coloured = moment();
  coloured.colour.fitted = grey;
  const SurfaceSnapshot plain = SurfaceSnapshot::take(coloured, clients).value();
  EXPECT_THAT(plain.wanted(*clients[0])[2].steps, testing::Each(0));
  coloured.colour.texture.filter.gain = 2;
  const SurfaceSnapshot snapshot = SurfaceSnapshot::take(coloured, clients).value();
  const auto wanted = snapshot.wanted(*clients[0]);
  EXPECT_THAT(wanted[1].steps, testing::Each(0.25 * 16 * 256));
  const size_t vertices = wanted[2].steps.size() / 3;
  EXPECT_THAT(wanted[2].steps.first(vertices), testing::Each(1 * 16 * 256));
  EXPECT_THAT(wanted[2].steps.subspan(vertices), testing::Each(0));
}

TEST_F(SurfaceSnapshotTest, AnUnmovedSurfaceNeedsNoSolver) {
  const std::shared_ptr<const ClientPages> clients[] = {client({0, 1})};
  const SurfaceSnapshot snapshot = SurfaceSnapshot::unmoved(clients);
  for (const WantedPage& wanted : snapshot.wanted(*clients[0])) {
    EXPECT_THAT(wanted.steps, testing::Each(0));
    EXPECT_EQ(wanted.gain, 0);
  }
  EXPECT_EQ(snapshot.largest_move(), 0);
}

TEST_F(SurfaceSnapshotTest, AGainFollowsTheLargestBetaInThePagesCells) {
  const std::shared_ptr<const ClientPages> clients[] = {client({0, 1})};
  const auto& cells = clients[0]->pages[0]->cells;
  const auto& others = clients[0]->pages[1]->cells;
  const auto own = std::ranges::find_if(
      cells, [&](int32_t cell) { return !std::ranges::binary_search(others, cell); });
  beta_[*own] = 5;
  const SurfaceSnapshot snapshot = SurfaceSnapshot::take(moment(), clients).value();
  EXPECT_EQ(snapshot.wanted(*clients[0])[0].gain, 3);
  EXPECT_EQ(snapshot.wanted(*clients[0])[1].gain, 0);
}

TEST_F(SurfaceSnapshotTest, TheLargestMoveIsOfTheWholeScan) {
  for (const bool settled : {true, false})
    EXPECT_FLOAT_EQ(SurfaceSnapshot::take(moment(settled), {}).value().largest_move(), 0.25F);
}

TEST_F(SurfaceSnapshotTest, ADisplacementThatIsNotFiniteIsAnError) {
  const std::shared_ptr<const ClientPages> clients[] = {client({0})};
  displacement_.assign(displacement_.size(), Vec3f::Constant(NAN));
  EXPECT_EQ(SurfaceSnapshot::take(moment(), clients).status().code(), StatusCode::kInternal);
}

}  // namespace
}  // namespace burnish
