#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "client/connection/connection.h"
#include "common/mesh/mesh_io.h"
#include "tests/system/server_process.h"

namespace burnish {
namespace {

using testing::Each;
using testing::HasSubstr;

/// A server with a sphere of radius 1 and a session over it.
class Views : public testing::Test {
 protected:
  Views() : connection_(Connection::open(server_.address, kPatience).value()) {
    scan_ = write_sphere(server_.folder, 4);
    EXPECT_TRUE(connection_.import_scan(scan_, "ball", {5, 0}, {}).is_ok());
    EXPECT_TRUE(connection_.open_session({"ball", "work", {5, 0}}).is_ok());
  }

  ServerProcess server_;
  Connection connection_;
  std::string scan_;
};

TEST_F(Views, OfAScanAreTheScan) {
  double last = 0;
  const Progress progress = [&](std::string_view, double fraction) {
    last = fraction;
    return true;
  };
  const View view = connection_.fetch_view({"ball", {5, 0}}, progress).value();
  EXPECT_EQ(last, 1);
  const TriangleMesh mesh = read_mesh(scan_).value();
  EXPECT_EQ(view.triangles, mesh.triangles);
  ASSERT_EQ(view.vertices.size(), mesh.vertices.size());
  for (size_t v = 0; v < mesh.vertices.size(); ++v)
    EXPECT_LT((view.vertices[v] - mesh.vertices[v]).norm(), 1e-6 * view.frame.cell_size);
}

TEST_F(Views, OfAProxyHaveNoMoreTrianglesThanAskedFor) {
  const View view = connection_.fetch_view({"ball", {5, 0}, 2000}, {}).value();
  EXPECT_TRUE(view.is_proxy());
  EXPECT_LE(view.triangles.size(), 2000u);
  EXPECT_EQ(view.scan_vertices, 2562u);
}

TEST_F(Views, AreFetchedUntilCancelled) {
  const Progress cancel = [](std::string_view, double) { return false; };
  EXPECT_EQ(connection_.fetch_view({"ball", {5, 0}}, cancel).status().code(),
            burnish::StatusCode::kCancelled);
  EXPECT_TRUE(connection_.fetch_view({"ball", {5, 0}}, {}).is_ok());
}

TEST_F(Views, OfWhatIsNotThereNameIt) {
  EXPECT_THAT(connection_.fetch_view({"cube", {5, 0}}, {}).status().message(),
              HasSubstr("no scan has the name or id 'cube'"));
  EXPECT_THAT(connection_.fetch_view({"ball", {7, 0}}, {}).status().message(),
              HasSubstr("is not prepared at depth 7"));
}

TEST_F(Views, CellsHaveTheValuesOfTheSession) {
  const View view = connection_.fetch_view({"ball", {5, 0}}, {}).value();
  const std::vector<Edit> edits = {{"a", SetGradientScale{0.25}},
                                   {"b", SetTransferCurve{TransferCurve(7)}}};
  ASSERT_TRUE(connection_.apply("work", edits).is_ok());
  const auto count = static_cast<size_t>(view.grid.cell_count());
  const auto values = [&](CellValue value) { return connection_.cells("work", value).value(); };
  EXPECT_EQ(values(CellValue::kBeta).size(), count);
  EXPECT_THAT(values(CellValue::kBeta), Each(0.25f));
  EXPECT_THAT(values(CellValue::kAlpha1), Each(7.f));
  EXPECT_THAT(values(CellValue::kAlpha2), Each(7.f));
  double mean = 0;
  for (const float kappa : values(CellValue::kKappa1)) mean += kappa / static_cast<double>(count);
  // 1/r times L = sqrt(4 pi r^2).
  EXPECT_NEAR(mean, 3.545, 0.05);
  EXPECT_EQ(connection_.cells("none", CellValue::kBeta).status().code(),
            burnish::StatusCode::kNotFound);
}

}  // namespace
}  // namespace burnish
