#include "common/view/view.h"

#include <gtest/gtest.h>

#include "tests/common/view/small_view.h"

namespace burnish {
namespace {

TEST(View, OfAWholeScanHasItsTrianglesPointsAndGrid) {
  const SmallScan& scan = small_scan();
  const View view = read_view(make_view(small_source(), 0).bytes).value();
  EXPECT_FALSE(view.is_proxy());
  EXPECT_EQ(view.triangles, scan.mesh.triangles);
  EXPECT_EQ(view.scan_vertices, scan.mesh.vertices.size());
  EXPECT_EQ(view.scan_triangles, scan.mesh.triangles.size());
  EXPECT_EQ(view.frame.origin, scan.frame.origin);
  EXPECT_EQ(view.frame.cell_size, scan.frame.cell_size);
  EXPECT_EQ(view.length_unit, 2);
  EXPECT_EQ(view.grid.cells, scan.grid.cells);
  EXPECT_EQ(view.grid.corners, scan.grid.corners);
  EXPECT_EQ(view.grid.cell_corners, scan.grid.cell_corners);
  ASSERT_EQ(view.points.size(), scan.points.size());
  for (size_t v = 0; v < scan.points.size(); ++v) {
    EXPECT_EQ(view.points[v].cell, scan.points[v].cell);
    EXPECT_EQ(view.points[v].local, scan.points[v].local);
    EXPECT_LT((view.vertices[v] - scan.mesh.vertices[v]).norm(), 1e-6 * scan.frame.cell_size);
  }
}

TEST(View, GivesTheFrameLayoutsOfTheServer) {
  const View view = read_view(make_view(small_source(), 0).bytes).value();
  const FrameMesh mesh{view.grid, view.points};
  EXPECT_EQ(make_coefficient_layout(mesh).fingerprint,
            small_layout(FrameContent::kCoefficients)->fingerprint);
  EXPECT_EQ(make_vertex_layout(mesh).fingerprint,
            small_layout(FrameContent::kVertices)->fingerprint);
}

TEST(View, OfAProxyIsOfTheScansGridAndGivesTheFrameLayoutOfThatProxy) {
  const ViewSource source = small_source();
  const View view = read_view(make_view(source, 1000).bytes).value();
  const Proxy proxy = make_proxy(source.mesh, 1000);
  EXPECT_TRUE(view.is_proxy());
  EXPECT_LE(view.triangles.size(), 1000u);
  EXPECT_EQ(view.triangles, proxy.triangles);
  EXPECT_EQ(view.scan_triangles, source.mesh.triangles.size());
  EXPECT_EQ(view.grid.cells, small_scan().grid.cells);
  EXPECT_EQ(make_coefficient_layout({view.grid, view.points}).fingerprint,
            make_coefficient_layout({small_scan().grid, proxy.evaluation}).fingerprint);
  EXPECT_EQ(make_vertex_layout({view.grid, view.points}).fingerprint,
            make_vertex_layout({small_scan().grid, proxy.evaluation}).fingerprint);
}

TEST(View, ThatMayHaveAllTrianglesIsTheWholeScan) {
  const ViewSource source = small_source();
  EXPECT_EQ(make_view(source, source.mesh.triangles.size()).bytes, make_view(source, 0).bytes);
  EXPECT_EQ(make_view(source, uint64_t{1} << 40).bytes, make_view(source, 0).bytes);
}

TEST(View, KeepsColoursAndVerticesInNoCell) {
  ViewSource source = small_source();
  std::vector<EvaluationPoint> points(source.mesh.evaluation.begin(), source.mesh.evaluation.end());
  points[3] = points[7] = {};
  std::vector<Rgba8> colours;
  for (size_t v = 0; v < points.size(); ++v) colours.push_back({uint8_t(v), uint8_t(v >> 8), 3, 4});
  source.mesh.evaluation = points;
  source.colours = colours;
  const View whole = read_view(make_view(source, 0).bytes).value();
  EXPECT_EQ(whole.colours, colours);
  EXPECT_EQ(whole.points[7].cell, kNone);
  EXPECT_EQ(whole.vertices[7], source.mesh.vertices[7]);
  EXPECT_LT((whole.vertices[8] - source.mesh.vertices[8]).norm(), 1e-6 * source.frame.cell_size);
  const View proxy = read_view(make_view(source, 500).bytes).value();
  EXPECT_EQ(proxy.colours.size(), proxy.vertices.size());
}

// Uses coordinates of a national grid in metres, and cells of 0.2 mm.
TEST(View, KeepsDetailFarFromTheOrigin) {
  const SmallScan& scan = small_scan();
  const Vec3d shift(455'000, 5'410'000, 300);
  std::vector<Vec3d> vertices;
  for (const Vec3d& vertex : scan.mesh.vertices)
    vertices.push_back(shift + 0.0002 / scan.frame.cell_size * vertex);
  ViewSource source = small_source();
  source.mesh.vertices = vertices;
  source.frame.origin = shift + 0.0002 / scan.frame.cell_size * scan.frame.origin;
  source.frame.cell_size = 0.0002;
  const View view = read_view(make_view(source, 0).bytes).value();
  for (size_t v = 0; v < vertices.size(); ++v)
    ASSERT_LT((view.vertices[v] - vertices[v]).norm(), 4e-9) << v;  // a double's step there
}

TEST(View, TheSameScanGivesTheSameBytes) {
  EXPECT_EQ(make_view(small_source(), 700).bytes, make_view(small_source(), 700).bytes);
}

TEST(View, TakesFewerBytesThanItsArrays) {
  const SmallScan& scan = small_scan();
  EXPECT_LT(make_view(small_source(), 0).bytes.size(),
            scan.mesh.vertices.size() * sizeof(EvaluationPoint) +
                scan.mesh.triangles.size() * sizeof(Triangle) / 2);
}

}  // namespace
}  // namespace burnish
