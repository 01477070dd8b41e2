#include <algorithm>

#include <epoxy/gl.h>

#include "client/scene/raw_pages.h"
#include "common/generate/generate.h"
#include "tests/client/gl/raw_stage.h"

namespace burnish {
namespace {

// NVIDIA's OpenGL ES has no such function. Browsers have it, or client/web/engine does the same.
void draw_one_by_one(GLenum mode, const GLsizei* counts, GLenum type, const void* const* offsets,
                     GLsizei draws) {
  for (GLsizei i = 0; i < draws; ++i) glDrawElements(mode, counts[i], type, offsets[i]);
}

Image draw_in(GlKind kind, const TriangleMesh& mesh, const DrawStyle& style) {
  const auto context = std::move(EglContext::create(kind)).value();
  if (kind == GlKind::kEmbedded) epoxy_glMultiDrawElements = draw_one_by_one;
  const auto renderer = std::move(GlPageRenderer::create()).value();
  const RawPages raw = make_raw_pages(mesh);
  const auto patches = std::move(upload_pages(raw, *renderer)).value();
  const Camera camera = frame_all({}, raw.box, kRawSize.aspect());
  const Status drawn = renderer->draw(camera, kRawSize, style, patches);
  EXPECT_TRUE(drawn.is_ok()) << drawn.message();
  return std::move(renderer->read_pixels()).value();
}

// Differences of all bytes, the smallest first.
std::vector<int> differences(const TriangleMesh& mesh, const DrawStyle& style) {
  const Image desktop = draw_in(GlKind::kDesktop, mesh, style);
  const Image embedded = draw_in(GlKind::kEmbedded, mesh, style);
  std::vector<int> all;
  for (size_t i = 0; i < desktop.rgb.size(); ++i)
    all.push_back(std::abs(desktop.rgb[i] - embedded.rgb[i]));
  std::sort(all.begin(), all.end());
  return all;
}

double mean_of(const std::vector<int>& all) {
  double sum = 0;
  for (const int one : all) sum += one;
  return sum / static_cast<double>(all.size());
}

// OpenGL ES 3.0 is what browsers have.
class EmbeddedPicture : public testing::Test {
 protected:
  const TriangleMesh mesh_ = generate_scan({"tablet", 10'000}).value();
};

TEST_F(EmbeddedPicture, IsThatOfTheDesktop) {
  const Ring ring{Vec3d(0, 0, 0), 0.2, Vec3f(1, 0, 0)};
  for (const DrawStyle& style :
       {DrawStyle{}, DrawStyle{.flat = true}, DrawStyle{.wireframe = true},
        DrawStyle{.rings = {ring}}, DrawStyle{.lighting = {.kind = LightKind::kRaking}},
        DrawStyle{.lighting = {.kind = LightKind::kBronze}}})
    EXPECT_LE(differences(mesh_, style).back(), 1);
}

// Its textures have no samples. So its light falls on averages of samples.
TEST_F(EmbeddedPicture, WithLightOfTheSurroundingsDiffersByLittle) {
  for (const Lighting& lighting :
       {Lighting{.kind = LightKind::kRadiance}, Lighting{.kind = LightKind::kCavity},
        Lighting{.occlusion = 1}}) {
    const std::vector<int> all = differences(mesh_, {.lighting = lighting});
    EXPECT_LT(mean_of(all), 1);
    EXPECT_LE(all[all.size() * 99 / 100], 8);
  }
}

constexpr LightKind kLightsOfBends[] = {LightKind::kRadiance, LightKind::kCavity};

// Edges reach past the border of a surface, where they have a depth and no normal. A light that
// divides by the part of the surface there is not a number, and drivers draw that as they like.
TEST_F(EmbeddedPicture, OfEdgesKeepsTheLightOfTheSurroundings) {
  for (const LightKind kind : kLightsOfBends) {
    const std::vector<int> all =
        differences(mesh_, {.wireframe = true, .lighting = {.kind = kind}});
    EXPECT_LT(mean_of(all), 1);
    EXPECT_LE(all[all.size() * 3999 / 4000], 60);
  }
}

TEST_F(EmbeddedPicture, EdgesBrightenNoPixelMuch) {
  for (const LightKind kind : kLightsOfBends) {
    const Lighting lighting{.kind = kind};
    const Image without = draw_in(GlKind::kEmbedded, mesh_, {.lighting = lighting});
    const Image with = draw_in(GlKind::kEmbedded, mesh_, {.wireframe = true, .lighting = lighting});
    for (size_t i = 0; i < with.rgb.size(); ++i)
      ASSERT_LE(with.rgb[i], without.rgb[i] + 60) << "byte " << i;
  }
}

}  // namespace
}  // namespace burnish
