#include <set>

#include "common/generate/generate.h"
#include "tests/client/gl/raw_stage.h"

namespace burnish {
namespace {

constexpr double kJump = 12;  // luminance, of 255
using Pixel = std::pair<int, int>;

/// Counts the outermost pixels that the surface covers as a whole, and those of them that are
/// brighter or darker than all of them beside it.
class Silhouette : public RawStage {
 protected:
  void measure(const TriangleMesh& mesh, const Lighting& lighting) {
    camera_ = {.azimuth_degrees = 25, .elevation_degrees = 20};
    show(mesh);
    image_ = draw(lighting);
    background_ = draw_nothing();
    std::set<Pixel> rim;
    for (int y = 2; y < kRawSize.height - 2; ++y)
      for (int x = 2; x < kRawSize.width - 2; ++x)
        if (is_covered_around(x, y, 1) && !is_covered_around(x, y, 2)) rim.insert({x, y});
    rim_ = static_cast<int>(rim.size());
    jumps_ = 0;
    for (const Pixel& pixel : rim) jumps_ += jumps(pixel, rim);
  }

  bool is_covered_around(int x, int y, int reach) const {
    for (int j = y - reach; j <= y + reach; ++j)
      for (int i = x - reach; i <= x + reach; ++i)
        if (std::equal(image_.pixel(i, j), image_.pixel(i, j) + 3, background_.pixel(i, j)))
          return false;
    return true;
  }

  bool jumps(const Pixel& pixel, const std::set<Pixel>& rim) const {
    const auto [x, y] = pixel;
    int beside = 0, brighter = 0, darker = 0;
    for (int j = -1; j <= 1; ++j)
      for (int i = -1; i <= 1; ++i) {
        if ((i == 0 && j == 0) || !rim.contains({x + i, y + j})) continue;
        const double by = luminance_at(image_, x, y) - luminance_at(image_, x + i, y + j);
        ++beside;
        brighter += by > kJump;
        darker += by < -kJump;
      }
    return beside >= 2 && (brighter == beside || darker == beside);
  }

  Image image_, background_;
  int rim_ = 0;
  int jumps_ = 0;
};

TEST_F(Silhouette, OfASphereHasNoDashes) {
  for (const LightKind kind : {LightKind::kClay, LightKind::kRadiance, LightKind::kRaking}) {
    measure(make_icosphere(5, 1), {.kind = kind});
    EXPECT_GT(rim_, 400);
    EXPECT_EQ(jumps_, 0) << name_of(kind);
  }
}

TEST_F(Silhouette, OfACoarseSphereHasNoDashes) {
  measure(make_icosphere(3, 1), {});
  EXPECT_EQ(jumps_, 0);
}

TEST_F(Silhouette, OfALumpySurfaceHasHardlyADash) {
  auto blob = generate_scan({.kind = "blob", .vertices = 20000});
  ASSERT_TRUE(blob.is_ok());
  measure(*blob, {});
  EXPECT_GT(rim_, 400);
  EXPECT_LE(jumps_, rim_ / 100);
}

}  // namespace
}  // namespace burnish
