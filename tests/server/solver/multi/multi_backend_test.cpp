// A scan in shards ends where the whole one does, call by call.

#include "server/solver/multi/multi_backend.h"

#include <algorithm>
#include <array>
#include <map>

#include <gtest/gtest.h>

#include "common/generate/generate.h"
#include "server/solver/cpu/cpu_backend.h"
#include "server/solver/cycle/vcycle.h"
#include "server/solver/multi/cpu_shards.h"
#include "server/solver/solver.h"
#include "tests/reference/awkward_meshes.h"
#include "tests/reference/shapes.h"
#include "tests/server/solver/test_system.h"

namespace burnish {
namespace {

constexpr int32_t kFew = 500;  // corners that stay whole in these tests

/// A solver of a scan and its fields, after edits.
class Edited {
 public:
  Edited(const TestSystem& on, int shards)
      : on_(on),
        fields_(*on.prepared),
        solver_(Solver::create(on, {.backend = BackendKind::kCpu,
                                    .threads = 1,
                                    .devices = shards,
                                    .whole_corners_max = kFew})
                    .value()) {}

  Edited& curve(const TransferCurve& curve) {
    fields_.set_transfer_curve(curve);
    return metric();
  }
  Edited& beta(double beta) {
    fields_.set_gradient_scale(beta);
    solver_->set_gradient_scale(fields_.view());
    return *this;
  }
  Edited& paint(size_t vertex, double beta) {
    const Brush brush{
        .radius = 0.15 * on_.prepared->statistics.diagonal(), .strength = 0.7, .beta = beta};
    fields_.paint(brush, std::array{on_.prepared->vertices[vertex]});
    solver_->set_gradient_scale(fields_.view());
    return *this;
  }
  /// Gives some cells an α of their own: a local new metric.
  Edited& own_cells(size_t first, size_t count, double alpha) {
    SetCellFields own;
    for (size_t c = first; c < first + count; ++c)
      own.cells.push_back({morton_point(on_.prepared->cells[c]), alpha, 2 * alpha, 0.5});
    EXPECT_TRUE(fields_.override_cells(own).is_ok());
    return metric();
  }
  Edited& metric() {
    solver_->set_metric(fields_.view());
    return *this;
  }
  Edited& steps(int count) {
    for (int i = 0; i < count; ++i) last_ = solver_->step();
    return *this;
  }
  Edited& solve() {
    EXPECT_TRUE(solver_->solve(1e-8, 400).value().converged);
    return *this;
  }

  Solver& solver() { return *solver_; }
  const StepReport& last() const { return last_; }
  std::vector<Vec3f> vertices() const {
    const auto moved = solver_->vertex_displacement();
    return {moved.begin(), moved.end()};
  }

 private:
  const TestSystem& on_;
  Fields fields_;
  std::unique_ptr<Solver> solver_;
  StepReport last_;
};

// Returns the largest distance of a vertex over the diagonal.
double between(const Edited& one, const Edited& other, const TestSystem& on) {
  const std::vector<Vec3f> a = one.vertices(), b = other.vertices();
  EXPECT_EQ(a.size(), b.size());
  double most = 0;
  for (size_t v = 0; v < a.size(); ++v) {
    EXPECT_TRUE(a[v].allFinite() && b[v].allFinite()) << v;
    most = std::max<double>(most, (a[v] - b[v]).norm());
  }
  return most * on.prepared->frame.cell_size / on.prepared->statistics.diagonal();
}

const std::map<std::string, TestSystem>& systems() {
  static const auto all = [] {
    std::map<std::string, TestSystem> made;
    made.try_emplace("sphere", reference::bumpy_sphere(3), 5);
    made.try_emplace("open sheet", reference::bumped_sheet(20), 5);
    made.try_emplace("small components", reference::small_components_over_a_sphere(), 5);
    made.try_emplace("components", reference::several_components(), 5);
    made.try_emplace("soup", reference::shaken_soup(reference::bumpy_sphere(3), 0.01), 5);
    made.try_emplace("tablet", generate_scan({.kind = "tablet", .vertices = 4000}).value(), 5);
    return made;
  }();
  return all;
}

class InShards : public testing::TestWithParam<int> {
 protected:
  int shards() const { return GetParam(); }
};
INSTANTIATE_TEST_SUITE_P(Shards, InShards, testing::Values(1, 2, 3, 4),
                         testing::PrintToStringParamName());

TransferCurve contrast_100() {
  return TransferCurve::parse("-20:5,20:500").value();
}

void edit(Edited& edited) {
  edited.curve(TransferCurve(20)).beta(0.3).steps(2);
  edited.paint(7, 2).steps(1);
  edited.beta(0.6).steps(1);
  edited.curve(contrast_100()).steps(2);
  edited.own_cells(100, 30, 80).steps(1);
  edited.own_cells(110, 40, 10).steps(1);
  edited.paint(400, 0).steps(1);
}

TEST_P(InShards, EditAfterEditEndsWhereTheWholeDoes) {
  for (const auto& [name, on] : systems()) {
    SCOPED_TRACE(name);
    Edited whole(on, 1), split(on, shards());
    edit(whole);
    edit(split);
    EXPECT_LE(between(whole, split, on), 1e-4);  // nothing has settled yet
    whole.solve();
    split.solve();
    EXPECT_LE(between(whole, split, on), 1e-8);
  }
}

TEST_P(InShards, TwoRunsGiveTheSameBits) {
  for (const char* name : {"small components", "tablet"}) {
    const TestSystem& on = systems().at(name);
    Edited one(on, shards()), other(on, shards());
    edit(one);
    edit(other);
    EXPECT_EQ(one.vertices(), other.vertices()) << name;
    EXPECT_EQ(one.last().energy, other.last().energy) << name;
  }
}

TEST(InOneShard, EverythingHasTheBitsOfTheWhole) {
  const TestSystem& on = systems().at("tablet");
  const auto shards = std::make_shared<const Shards>(make_shards(on, 1, kFew));
  EXPECT_EQ(shards->all[0].own_corners, on.hierarchy->depths.back().grid.corner_count());
  auto steps = std::make_shared<LockStep>(1);
  CpuShards made = make_cpu_shards(shards, *steps);
  const auto halos = std::make_shared<CpuShards>(CpuShards{std::move(made.halos), {}});
  const auto split = make_multi_backend(on, {shards, steps, halos, std::move(made.backends)});
  const auto whole = make_cpu_backend(on, Smoother::kSchwarz);
  Fields fields(*on.prepared);
  fields.set_transfer_curve(contrast_100());
  fields.set_gradient_scale(0.3);
  for (Backend* backend : {split.get(), whole.get()}) {
    backend->set_metric(fields.view().metric);
    backend->set_constraint(fields.view());
    backend->recompute_residual();
    run_vcycle(*backend, on, on.hierarchy->finest);
    backend->update_direction(true);
    backend->advance();
  }
  EXPECT_EQ(split->measure().energy, whole->measure().energy);
  EXPECT_TRUE(std::ranges::equal(split->displacement(), whole->displacement()));
  EXPECT_TRUE(std::ranges::equal(split->vertex_displacement(), whole->vertex_displacement()));
}

TEST_P(InShards, AStepHasTheMeasuresOfTheWhole) {
  const TestSystem& on = systems().at("sphere");
  Edited whole(on, 1), split(on, shards());
  for (Edited* edited : {&whole, &split}) edited->curve(TransferCurve(20)).beta(0).steps(3);
  EXPECT_NEAR(split.last().energy / whole.last().energy, 1, 1e-6);
  EXPECT_NEAR(split.last().residual / whole.last().residual, 1, 1e-2);
  EXPECT_NEAR(split.last().distance / whole.last().distance, 1, 1e-2);
}

TEST_P(InShards, AnotherSignalThanPlacesIsSolvedToo) {
  const TestSystem& on = systems().at("small components");
  std::vector<Vec3f> signal;
  for (const GridKey& corner : on.hierarchy->depths.back().grid.corners)
    signal.push_back((0.1 * morton_point(corner.place).cast<double>()).array().sin().cast<float>());
  Edited whole(on, 1), split(on, shards());
  for (Edited* edited : {&whole, &split}) {
    edited->solver().set_signal(signal);
    edited->curve(TransferCurve(20)).beta(0).solve();
  }
  EXPECT_LE(between(whole, split, on), 1e-8);
  EXPECT_GT(whole.solver().displacement()[0].norm(), 0);
}

// Every call goes on without a shard that has nothing.
TEST(AnEmptyShard, ChangesNothing) {
  const TestSystem& on = systems().at("small components");
  const auto moved = [&](const Cut& cut) {
    const auto shards = std::make_shared<const Shards>(make_shards(on, cut));
    auto steps = std::make_shared<LockStep>(cut.shards);
    CpuShards made = make_cpu_shards(shards, *steps);
    const auto halos = std::make_shared<CpuShards>(CpuShards{std::move(made.halos), {}});
    const auto backend = make_multi_backend(on, {shards, steps, halos, std::move(made.backends)});
    Fields fields(*on.prepared);
    fields.set_gradient_scale(0.3);
    backend->set_metric(fields.view().metric);
    backend->set_constraint(fields.view());
    backend->recompute_residual();
    run_full_multigrid(*backend, on, on.hierarchy->finest);
    backend->update_direction(true);
    backend->advance();
    const auto u = backend->displacement();
    return std::vector<Vec3f>(u.begin(), u.end());
  };
  Cut cut = cut_hierarchy(*on.hierarchy, on.plan->patches, 2, border_depth(*on.hierarchy, kFew));
  const std::vector<Vec3f> without = moved(cut);
  cut.shards = 3;
  EXPECT_EQ(moved(cut), without);
}

}  // namespace
}  // namespace burnish
