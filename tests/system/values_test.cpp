#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/system/fetched_pages.h"
#include "tests/system/server_process.h"

namespace burnish {
namespace {

using testing::Contains;
using testing::Each;

/// A server with a sphere of radius 1 and a session over it.
class SessionValues : public testing::Test {
 protected:
  SessionValues() : connection_(Connection::open(server_.address, kPatience).value()) {
    EXPECT_TRUE(
        connection_.import_scan(write_sphere(server_.folder, 4), "ball", {5, 0}, {}).is_ok());
    EXPECT_TRUE(connection_.open_session({"ball", "work", {5, 0}}).is_ok());
    const std::vector<Edit> edits = {{"a", SetGradientScale{0.25}},
                                     {"b", SetTransferCurve{TransferCurve(7)}}};
    EXPECT_TRUE(connection_.apply("work", edits).is_ok());
  }

  ServerProcess server_;
  Connection connection_;
};

// 1/r times L = sqrt(4 pi r^2).
constexpr double kKappaOfASphere = 3.545;

TEST_F(SessionValues, ComeForAllCells) {
  const auto count = connection_.describe_scan("ball", 5).value().prepared.value().cells;
  const auto values = [&](CellValue value) { return connection_.cells("work", value).value(); };
  EXPECT_EQ(values(CellValue::kBeta).size(), count);
  EXPECT_THAT(values(CellValue::kBeta), Each(0.25f));
  EXPECT_THAT(values(CellValue::kAlpha1), Each(7.f));
  EXPECT_THAT(values(CellValue::kAlpha2), Each(7.f));
  double mean = 0;
  for (const float kappa : values(CellValue::kKappa1)) mean += kappa / static_cast<double>(count);
  EXPECT_NEAR(mean, kKappaOfASphere, 0.05);
  EXPECT_EQ(connection_.cells("none", CellValue::kBeta).status().code(),
            burnish::StatusCode::kNotFound);
}

TEST_F(SessionValues, TellWhatIsProtectedAndWhichCurveRules) {
  Stroke around{{.radius = 0.5, .strength = 1, .fall_off = FallOff::kConstant}, {Vec3d(0, 0, 1)}};
  around.brush.curve = 1;
  const std::vector<Edit> edits = {
      {"p", SetPalette{Palette{{{"soft", 0x4a7fd0, TransferCurve(20)}}}}}, {"s", around}};
  ASSERT_TRUE(connection_.apply("work", edits).is_ok());
  const auto ruled = connection_.cells("work", CellValue::kCurve).value();
  EXPECT_THAT(ruled, Contains(1.f));
  EXPECT_THAT(ruled, Contains(0.f));
  EXPECT_THAT(connection_.cells("work", CellValue::kProtected).value(), Each(0.f));
  const std::vector<Edit> protect = {{"r", Protect{PieceRegion{Vec3d(0, 0, 1)}}}};
  ASSERT_TRUE(connection_.apply("work", protect).is_ok());
  EXPECT_THAT(connection_.cells("work", CellValue::kProtected).value(), Each(1.f));
  const Status refused = connection_.apply("work", std::vector<Edit>{{"t", around}}).status();
  EXPECT_EQ(refused.code(), burnish::StatusCode::kFailedPrecondition);
}

TEST_F(SessionValues, ComeForTheVerticesOfPages) {
  const FetchedPages fetched = fetch_all_pages(connection_, "ball");
  const std::vector<PageId> pages = {fetched.head.root(), 0};
  const auto beta = connection_.page_values("work", CellValue::kBeta, pages).value();
  ASSERT_EQ(beta.size(), 2u);
  EXPECT_EQ(beta[0].page, fetched.head.root());
  EXPECT_EQ(beta[1].page, 0u);
  EXPECT_EQ(beta[0].at(0), 0.25f);
  EXPECT_TRUE(beta[0].steps.empty()) << "all are alike";
  const Stroke stroke{{.radius = 0.5, .strength = 1, .beta = 2}, {Vec3d(0, 0, 1)}};
  ASSERT_TRUE(connection_.apply("work", std::vector<Edit>{{"c", stroke}}).is_ok());
  const auto painted = connection_.page_values("work", CellValue::kBeta, pages).value();
  EXPECT_EQ(painted[0].low, 0.25f);
  EXPECT_NEAR(painted[0].high, 2, 0.1);
  const Page& root = *fetched.pages.back();
  ASSERT_EQ(painted[0].steps.size(), root.positions.size());
  for (size_t v = 0; v < root.positions.size(); ++v) {
    const double away = (fetched.head.grid.to_file(root.positions[v]) - Vec3d(0, 0, 1)).norm();
    if (away > 0.65) {
      EXPECT_EQ(painted[0].at(v), 0.25f);
    }
    if (away < 0.1) {
      EXPECT_GT(painted[0].at(v), 1.5f);
    }
  }
}

}  // namespace
}  // namespace burnish
