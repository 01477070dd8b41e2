#include <gtest/gtest.h>

#include "client/gl/context_egl.h"
#include "client/gl/gl_renderer.h"
#include "client/scene/displaced_surface.h"
#include "client/scene/null_renderer.h"
#include "tests/client/scene/gridded_sphere.h"

namespace burnish {
namespace {

constexpr ImageSize kDisplacedSize{400, 300};

class DisplacedPicture : public testing::Test {
 protected:
  void SetUp() override {
    auto context = EglContext::create();
    ASSERT_TRUE(context.is_ok()) << context.status().message();
    context_ = std::move(context).value();
    renderer_ = std::move(GlRenderer::create()).value();
    ASSERT_TRUE(renderer_->upload_mesh(mesh_).is_ok());
    camera_.target = mesh_.box.center();
    camera_.distance = 6;
    camera_.scene_radius = 3;
  }

  void displace(Renderer& renderer, const std::vector<Vec3f>& displacements) {
    const IndexRange all{0, displacements.size()};
    ASSERT_TRUE(renderer.upload_displacements(displacements, {&all, 1}).is_ok());
  }

  Image draw(const DrawStyle& style = {}) {
    EXPECT_TRUE(renderer_->draw(camera_, kDisplacedSize, style).is_ok());
    return std::move(renderer_->read_pixels()).value();
  }

  // Draws the same surface with its vertices moved one by one.
  Image draw_moved(const std::vector<Vec3f>& displacements) {
    View moved = view_;
    for (uint32_t v = 0; v < moved.vertices.size(); ++v)
      moved.vertices[v] = displaced_vertex({mesh_, displacements}, v);
    moved.points.assign(moved.points.size(), {});  // no vertex is in a cell, so nothing moves again
    EXPECT_TRUE(renderer_->upload_mesh(make_view_mesh(moved)).is_ok());
    return draw();
  }

  const View view_ = make_sphere_view();
  const ViewMesh mesh_ = make_view_mesh(view_);
  Camera camera_;
  std::unique_ptr<EglContext> context_;  // outlives the renderer
  std::unique_ptr<GlRenderer> renderer_;
};

double mean_difference(const Image& a, const Image& b) {
  double sum = 0;
  for (size_t i = 0; i < a.rgb.size(); ++i) sum += std::abs(int{a.rgb[i]} - int{b.rgb[i]});
  return sum / static_cast<double>(a.rgb.size());
}

Vec3f wave(const Vec3d& corner) {
  return Vec3d(0.6 * std::sin(0.5 * corner.y()), 0.8 * std::cos(0.4 * corner.x()),
               0.05 * corner.x())
      .cast<float>();
}

TEST_F(DisplacedPicture, TheCardMovesVerticesAndNormalsAsTheCpuDoes) {
  const std::vector<Vec3f> displacements = displace_corners(view_, wave);
  const Image still = draw();
  displace(*renderer_, displacements);
  const Image by_card = draw();
  const Image by_cpu = draw_moved(displacements);
  EXPECT_GT(mean_difference(still, by_cpu), 2);
  EXPECT_LT(mean_difference(by_card, by_cpu), 0.5);
}

TEST_F(DisplacedPicture, NormalsOfAnAffineMapAreExact) {
  const Eigen::Matrix3d map{{0.2, 0.3, 0}, {0, -0.3, 0.1}, {0.1, 0, 0.4}};
  const std::vector<Vec3f> displacements = displace_corners(view_, [&](const Vec3d& corner) {
    return Vec3f((map * (corner - Vec3d(8, 8, 8))).cast<float>());
  });
  displace(*renderer_, displacements);
  const Image by_card = draw();
  EXPECT_LT(mean_difference(by_card, draw_moved(displacements)), 0.15);
}

TEST_F(DisplacedPicture, OnlyTheChangedRangesAreTaken) {
  const std::vector<Vec3f> none(mesh_.corner_count, Vec3f::Zero());
  const std::vector<Vec3f> displacements = displace_corners(view_, wave);
  const Image still = draw();
  const IndexRange first_half{0, displacements.size() / 2};
  ASSERT_TRUE(renderer_->upload_displacements(displacements, {&first_half, 1}).is_ok());
  const Image half = draw();
  displace(*renderer_, displacements);
  EXPECT_GT(mean_difference(half, still), 0.5);
  EXPECT_GT(mean_difference(half, draw()), 0.5);
  displace(*renderer_, none);
  EXPECT_EQ(mean_difference(still, draw()), 0);
}

TEST_F(DisplacedPicture, TheOriginalIsShownAloneOrOnTheLeftOfTheSplit) {
  const Image still = draw();
  displace(*renderer_, displace_corners(view_, wave));
  const Image moved = draw();
  EXPECT_EQ(mean_difference(still, draw({.original = true})), 0);
  const Image split = draw({.split = 0.5});
  for (int x : {150, 190})
    EXPECT_TRUE(std::equal(split.pixel(x, 150), split.pixel(x, 150) + 3, still.pixel(x, 150)));
  for (int x : {210, 250})
    EXPECT_TRUE(std::equal(split.pixel(x, 150), split.pixel(x, 150) + 3, moved.pixel(x, 150)));
}

TEST_F(DisplacedPicture, CellsShowBlueAndRed) {
  std::vector<float> values;
  for (const GridKey& cell : view_.grid.cells)
    values.push_back(morton_point(cell.place).x() < 8 ? -1.0f : 1.0f);
  ASSERT_TRUE(renderer_->upload_cell_values(values).is_ok());
  const Image image = draw({.colouring = Colouring::kCells});
  EXPECT_GT(image.pixel(150, 150)[2], image.pixel(150, 150)[0] + 40);
  EXPECT_GT(image.pixel(250, 150)[0], image.pixel(250, 150)[2] + 40);
}

TEST_F(DisplacedPicture, OutwardMovesAreRedAndInwardOnesBlue) {
  displace(*renderer_, displace_corners(view_, [](const Vec3d& corner) {
    return Vec3f((0.1 * (corner - Vec3d(8, 8, 8))).cast<float>());
  }));
  const Image outwards = draw({.colouring = Colouring::kDisplacement});
  EXPECT_GT(outwards.pixel(200, 150)[0], outwards.pixel(200, 150)[2] + 40);
  displace(*renderer_, displace_corners(view_, [](const Vec3d& corner) {
    return Vec3f((-0.1 * (corner - Vec3d(8, 8, 8))).cast<float>());
  }));
  const Image inwards = draw({.colouring = Colouring::kDisplacement});
  EXPECT_GT(inwards.pixel(200, 150)[2], inwards.pixel(200, 150)[0] + 40);
}

TEST_F(DisplacedPicture, ARingIsDrawnAroundItsCentreAndATintInside) {
  const Vec3d front = mesh_.box.center() + Vec3d(0, 0, 1);
  const Image plain = draw();
  const Image ring = draw({.rings = {{front, 0.4, Vec3f(1, 0, 0)}}});
  const Eigen::Vector2d edge = pixel_of(camera_, kDisplacedSize, front + Vec3d(0.392, 0, -0.08));
  int red = 0;  // the ring is several pixels wide
  for (int x = int(edge.x()) - 4; x <= int(edge.x()) + 4; ++x) {
    const uint8_t* rgb = ring.pixel(x, kDisplacedSize.height / 2);
    red += rgb[0] > 200 && rgb[1] < 80;
  }
  EXPECT_GT(red, 0);
  EXPECT_TRUE(std::equal(ring.pixel(200, 150), ring.pixel(200, 150) + 3, plain.pixel(200, 150)));
  const std::vector<float> tint(mesh_.cell_corners.size(), 1.0f);
  ASSERT_TRUE(renderer_->upload_cell_tint(tint, {0, tint.size()}).is_ok());
  const Image tinted = draw({.tint = Vec3f(0, 0, 1)});
  EXPECT_GT(tinted.pixel(200, 150)[2], plain.pixel(200, 150)[2]);
  EXPECT_LT(tinted.pixel(200, 150)[0], plain.pixel(200, 150)[0]);
}

TEST_F(DisplacedPicture, ARingHoldsWhatTheBrushChangesWhereverItIsNow) {
  const std::vector<Vec3f> displacements = displace_corners(view_, wave);
  displace(*renderer_, displacements);
  const Vec3d front = mesh_.box.center() + Vec3d(0, 0, 1);
  const Image ring = draw({.rings = {{front, 0.4, Vec3f(1, 0, 0)}}});
  int drawn = 0;
  for (int y = 0; y < kDisplacedSize.height; ++y) {
    for (int x = 0; x < kDisplacedSize.width; ++x) {
      const uint8_t* rgb = ring.pixel(x, y);
      if (rgb[0] < 200 || rgb[1] > 80) continue;
      const auto triangle =
          std::move(renderer_->pick(camera_, kDisplacedSize, {x, y}, false)).value();
      ASSERT_TRUE(triangle.has_value());
      const Ray ray = pixel_ray(camera_, kDisplacedSize, Eigen::Vector2d(x + 0.5, y + 0.5));
      const auto hit = point_on_triangle({mesh_, displacements}, ray, *triangle);
      ASSERT_TRUE(hit.has_value());
      EXPECT_NEAR((hit->original - front).norm(), 0.4, 0.04) << x << " " << y;
      ++drawn;
    }
  }
  EXPECT_GT(drawn, 100);
}

TEST_F(DisplacedPicture, PicksTheTriangleThatAllTriangleTestsFind) {
  NullRenderer reference;
  ASSERT_TRUE(reference.upload_mesh(mesh_).is_ok());
  const std::vector<Vec3f> displacements = displace_corners(view_, wave);
  displace(*renderer_, displacements);
  displace(reference, displacements);
  for (const bool original : {false, true}) {
    DisplacedSurface surface{mesh_, displacements};
    if (original) surface.displacements = {};
    int hits = 0, same = 0;
    for (int y = 5; y < kDisplacedSize.height; y += 20) {
      for (int x = 5; x < kDisplacedSize.width; x += 20) {
        const auto found =
            std::move(renderer_->pick(camera_, kDisplacedSize, {x, y}, original)).value();
        const auto expected =
            std::move(reference.pick(camera_, kDisplacedSize, {x, y}, original)).value();
        hits += expected.has_value();
        same += found == expected;
        if (!found || !expected) continue;
        const Ray ray = pixel_ray(camera_, kDisplacedSize, Eigen::Vector2d(x + 0.5, y + 0.5));
        const auto a = point_on_triangle(surface, ray, *found);
        const auto b = nearest_hit(surface, ray);
        ASSERT_TRUE(a && b);
        EXPECT_LT((a->original - b->original).norm(), 1e-3);
        EXPECT_LT((a->displaced - b->displaced).norm(), 1e-3);
      }
    }
    EXPECT_GT(hits, 40);
    EXPECT_GE(same, 300 - 3);  // of 300 pixels; some lie on an edge
  }
}

}  // namespace
}  // namespace burnish
