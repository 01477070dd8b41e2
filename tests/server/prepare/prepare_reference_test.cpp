#include <gtest/gtest.h>

#include "server/prepare/cell_integrals.h"
#include "server/prepare/prepare.h"
#include "tests/reference/awkward_meshes.h"
#include "tests/reference/reference.h"

namespace burnish {
namespace {

using reference::Matrix8d;

struct Sample {
  std::string name;
  reference::System system;
  std::shared_ptr<const PreparedMesh> prepared;
};

const std::vector<Sample>& samples() {
  static const std::vector<Sample> all = [] {
    PrepareOptions options;
    options.depth = 5;
    std::vector<Sample> made;
    for (const auto& [name, mesh] : reference::awkward_meshes())
      made.push_back({name, reference::build(mesh, 5), *prepare(mesh, options)});
    return made;
  }();
  return all;
}

// Returns the stored pairs as a full matrix; its diagonal makes row a sum to row_sum(a).
template <typename RowSum>
Matrix8d expanded(const std::array<double, 28>& pairs, RowSum&& row_sum) {
  Matrix8d full = Matrix8d::Zero();
  for (int a = 0, pair = 0; a < 8; ++a)
    for (int b = a + 1; b < 8; ++b, ++pair) full(a, b) = full(b, a) = pairs[pair];
  for (int a = 0; a < 8; ++a) full(a, a) = row_sum(a) - full.row(a).sum();
  return full;
}

Matrix8d mass_of(const CellIntegrals& cell) {
  return expanded(cell.mass, [&](int a) { return cell.mass_row_sum[a]; });
}

Matrix8d stiffness_of(const CellIntegrals& cell, int direction) {
  return expanded(cell.stiffness[direction], [](int) { return 0; });
}

// Calls compare(reference cell, index of the product's cell) for the cells in both.
template <typename Compare>
void for_each_common_cell(const Sample& sample, Compare&& compare) {
  const PreparedMesh& prepared = *sample.prepared;
  for (size_t c = 0; c < prepared.cells.size(); ++c) {
    const Vec3i key = morton_point(prepared.cells[c]);
    const reference::Cell* cell = sample.system.find_cell({key.x(), key.y(), key.z()});
    if (cell != nullptr) compare(*cell, c);
  }
}

TEST(PrepareAndReference, HaveTheSameCells) {
  for (const Sample& sample : samples()) {
    SCOPED_TRACE(sample.name);
    const auto& [name, system, prepared] = sample;
    size_t common = 0;
    for_each_common_cell(sample, [&](const auto&, size_t) { ++common; });
    EXPECT_EQ(common, prepared->cells.size());
    EXPECT_EQ(common, system.cells.size());
    EXPECT_NEAR(prepared->length_unit, system.length_unit, 1e-12 * system.length_unit);
  }
}

TEST(PrepareAndReference, AgreeOnMassAndOnBothDirectionsTogether) {
  for (const Sample& sample : samples()) {
    SCOPED_TRACE(sample.name);
    double mass = 0, both = 0;
    for_each_common_cell(sample, [&](const auto& cell, size_t c) {
      const CellIntegrals& found = sample.prepared->integrals[c];
      const Matrix8d sum = stiffness_of(found, 0) + stiffness_of(found, 1);
      mass = std::max(mass, (mass_of(found) - cell.rho).norm() / cell.area);
      both = std::max(both, (sum - cell.ell1 - cell.ell2).norm() / cell.area);
    });
    EXPECT_LT(mass, 1e-5);
    EXPECT_LT(both, 1e-5);
  }
}

TEST(PrepareAndReference, AgreeOnCurvatureAndItsDirections) {
  for (const Sample& sample : samples()) {
    SCOPED_TRACE(sample.name);
    double kappa = 0, stiffness = 0;
    for_each_common_cell(sample, [&](const auto& cell, size_t c) {
      const CellCurvature& found = sample.prepared->curvature[c];
      const double largest = std::max({std::abs(cell.kappa1), std::abs(cell.kappa2), 1.0});
      const double difference =
          std::max(std::abs(found.kappa1 - cell.kappa1), std::abs(found.kappa2 - cell.kappa2));
      kappa = std::max(kappa, difference / largest);
      const Matrix8d error = stiffness_of(sample.prepared->integrals[c], 0) - cell.ell1;
      stiffness = std::max(stiffness, error.norm() / cell.area);
    });
    EXPECT_LT(kappa, 1e-5);
    EXPECT_LT(stiffness, 1e-5);
  }
}

}  // namespace
}  // namespace burnish
