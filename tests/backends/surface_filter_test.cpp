// Facts about the filter of a surface's normals on every backend.

#include "common/denoise/surface_filter.h"

#include <cstdio>
#include <cstdlib>
#include <limits>
#include <memory>
#include <thread>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "common/generate/generate.h"
#include "server/solver/cuda/cuda_backend.h"
#include "server/solver/cuda/cuda_filter.h"
#include "server/solver/surface_filters.h"
#include "tests/backends/fault.h"
#include "tests/backends/on_a_device.h"
#include "tests/common/odd_triangles.h"

namespace burnish {
namespace {

TriangleMesh noisy(std::string kind, uint64_t vertices) {
  return generate_scan({std::move(kind), vertices, 1, 0.2, NoiseKind::kGauss}).value();
}

/// A surface that has its mesh.
struct OwnSurface {
  explicit OwnSurface(TriangleMesh from) : mesh(std::move(from)), surface(mesh) {}
  TriangleMesh mesh;
  DenoiseSurface surface;
};

std::shared_ptr<const DenoiseSurface> surface_of(TriangleMesh mesh) {
  const auto own = std::make_shared<OwnSurface>(std::move(mesh));
  return {own, &own->surface};
}

/// The filters of kept edges that people are offered.
std::vector<EdgeFilter> offered() {
  std::vector<EdgeFilter> filters;
  for (const EdgePreset& preset : edge_presets()) filters.push_back(preset.filter);
  return filters;
}

void expect_same_bits(const FilteredSurface& a, const FilteredSurface& b, const std::string& what) {
  EXPECT_EQ(a.normals, b.normals) << what;
  EXPECT_EQ(a.layer, b.layer) << what;
}

/// Expects of one surface that both backends give the same normals and moves for all filters.
void expect_what_processors_give(const TriangleMesh& mesh, const std::string& name) {
  const auto surface = surface_of(mesh);
  const auto expected = make_processor_filter(surface);
  const auto there = make_cuda_filter(surface);
  ASSERT_TRUE(there.is_ok()) << there.status().to_string();
  for (const EdgeFilter& filter : offered()) {
    const auto found = there.value()->filter(filter);
    ASSERT_TRUE(found.is_ok()) << found.status().to_string();
    expect_same_bits(*found, expected->filter(filter).value(),
                     name + ", " + std::string(preset_of(filter)->name));
  }
}

TEST(SurfaceFilter, OfProcessorsGivesTheLayerAndUnitNormals) {
  const TriangleMesh mesh = noisy("part", 2000);
  const auto surface = surface_of(mesh);
  for (const EdgeFilter& wanted : offered()) {
    const auto filtered = make_processor_filter(surface)->filter(wanted).value();
    EXPECT_EQ(filtered.layer, denoise_layer(*surface, wanted).value());
    ASSERT_EQ(filtered.normals.size(), mesh.triangles.size());
    for (const Vec3f& normal : filtered.normals) EXPECT_NEAR(normal.norm(), 1, 1e-6);
  }
}

TEST(SurfaceFilter, RefusesAFilterThatIsNone) {
  EdgeFilter wanted = offered()[0];
  wanted.passes = -1;
  for (const BackendKind backend : {BackendKind::kCpu, BackendKind::kAuto}) {
    const auto filter = make_surface_filter(backend, surface_of(make_icosphere(1, 1))).value();
    EXPECT_EQ(filter->filter(wanted).status().code(), StatusCode::kInvalidArgument);
  }
}

TEST(SurfaceFilter, HearsACancel) {
  const auto surface = surface_of(noisy("part", 2000));
  for (const BackendKind backend : {BackendKind::kCpu, BackendKind::kAuto}) {
    const auto filter = make_surface_filter(backend, surface).value();
    for (const std::string_view phase : {"normals", "layer"}) {
      const auto leaves = [&](std::string_view now, double) { return now != phase; };
      EXPECT_EQ(filter->filter(offered()[0], leaves).status().code(), StatusCode::kCancelled);
    }
    expect_same_bits(filter->filter(offered()[0]).value(),
                     make_processor_filter(surface)->filter(offered()[0]).value(), "afterwards");
  }
}

TEST_F(OnADevice, FilteredSurfacesAreThoseOfProcessors) {
  for (const char* kind : {"part", "coin", "blob", "wall", "soup", "fan", "sheets"})
    expect_what_processors_give(noisy(kind, 20'000), kind);
  for (const auto& [name, mesh] : with_triangles_of_no_surface(noisy("part", 2000)))
    expect_what_processors_give(mesh, name);
  expect_what_processors_give({}, "no triangle");
}

TEST_F(OnADevice, AFarSurfaceIsFilteredAsOnProcessors) {
  TriangleMesh mesh = noisy("part", 5000);
  for (Vec3d& at : mesh.vertices) at = 1e-3 * at + Vec3d(1e4, -2e5, 3e3);
  expect_what_processors_give(mesh, "far");
}

// A drag of the edge angle goes back and forth over one filter.
TEST_F(OnADevice, AFilterRemembersNothingOfTheLastOne) {
  const auto surface = surface_of(noisy("part", 5000));
  const auto used = make_cuda_filter(surface).value();
  for (const double angle : {20.0, 50.0, 20.0})
    for (EdgeFilter wanted : offered()) {
      wanted.edge_angle = angle;
      const auto fresh = make_cuda_filter(surface).value();
      expect_same_bits(used->filter(wanted).value(), fresh->filter(wanted).value(), "used");
    }
}

TEST_F(OnADevice, SeveralThreadsMayFilterOneSurface) {
  const auto surface = surface_of(noisy("part", 5000));
  const auto filter = make_cuda_filter(surface).value();
  const std::vector<EdgeFilter> wanted = offered();
  std::vector<FilteredSurface> found(wanted.size());
  {
    std::vector<std::jthread> threads;
    for (size_t i = 0; i < wanted.size(); ++i)
      threads.emplace_back([&, i] { found[i] = filter->filter(wanted[i]).value(); });
  }
  for (size_t i = 0; i < wanted.size(); ++i)
    expect_same_bits(found[i], make_processor_filter(surface)->filter(wanted[i]).value(), "thread");
}

TEST_F(OnADevice, AFilterTakesAllItsMemoryAtOnceAndGivesItBack) {
  const TriangleMesh mesh = noisy("part", 5000);
  const uint64_t before = cuda_memory_used();
  {
    const auto filter = make_cuda_filter(surface_of(mesh)).value();
    EXPECT_EQ(cuda_memory_used(), before + filter->byte_count());
    EXPECT_LE(filter->byte_count(),
              predict_cuda_filter_bytes(mesh.triangles.size(), mesh.vertices.size()));
    for (const EdgeFilter& wanted : offered()) EXPECT_TRUE(filter->filter(wanted).is_ok());
    EXPECT_EQ(cuda_memory_used(), before + filter->byte_count());
  }
  EXPECT_EQ(cuda_memory_used(), before);
}

TEST_F(OnADevice, WithoutRoomThereProcessorsFilter) {
  const auto surface = surface_of(noisy("part", 5000));
  const uint64_t before = cuda_memory_used();
  set_cuda_memory_budget(before + 100'000);
  const auto none = make_cuda_filter(surface);
  const auto filter = make_surface_filter(BackendKind::kCuda, surface);
  set_cuda_memory_budget(std::numeric_limits<uint64_t>::max());
  EXPECT_EQ(none.status().code(), StatusCode::kResourceExhausted);
  ASSERT_TRUE(filter.is_ok()) << filter.status().to_string();
  EXPECT_EQ(filter.value()->byte_count(), 0);
  EXPECT_EQ(cuda_memory_used(), before);
  expect_same_bits(filter.value()->filter(offered()[0]).value(),
                   make_processor_filter(surface)->filter(offered()[0]).value(), "no room");
}

// Runs in its own process: after the fault that has no device.
TEST_F(OnADevice, AFaultSticksToAFilter) {
  testing::FLAGS_gtest_death_test_style = "threadsafe";
  const auto live_on = [] {
    const TriangleMesh mesh = noisy("part", 2000);
    const auto surface = surface_of(mesh);
    const auto filter = make_cuda_filter(surface).value();
    const bool was_well = filter->filter(offered()[0]).is_ok();
    provoke_cuda_fault();
    const auto filtered = filter->filter(offered()[1]);
    const bool told =
        filtered.status().code() == StatusCode::kInternal &&
        filter->filter(offered()[0]).status().code() == StatusCode::kInternal &&
        make_surface_filter(BackendKind::kCuda, surface).status().code() == StatusCode::kInternal;
    std::fprintf(stderr, "%s\n", filtered.status().message().c_str());
    std::_Exit(was_well && told ? 0 : 1);
  };
  EXPECT_EXIT(live_on(), testing::ExitedWithCode(0), "CUDA: ");
}

}  // namespace
}  // namespace burnish
