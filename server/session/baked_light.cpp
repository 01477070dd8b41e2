#include "server/session/baked_light.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

#include "common/evaluation/evaluation.h"
#include "server/session/corner_normals.h"

namespace burnish {
namespace {

constexpr int kTerms = 18;  // without the constant
using Terms = Eigen::Matrix<double, kTerms, 1>;

// Darker colours count as so dark: their logarithm says little about light.
constexpr float kDarkest = 1 / 512.F;
// A part of a term's mean square, which is below 1. A flat scan has one normal, and terms that are
// equal.
constexpr double kStiffness = 1e-2;
// So many vertices tell as much as all of a large scan.
constexpr size_t kVerticesMax = size_t{1} << 18;

/// Writes a vector, its squares and its products.
Eigen::Matrix<double, 9, 1> second_degree(const Vec3d& v) {
  Eigen::Matrix<double, 9, 1> terms;
  terms << v, v.cwiseProduct(v), v.x() * v.y(), v.y() * v.z(), v.z() * v.x();
  return terms;
}

Terms terms_at(const Vec3f& normal, const Vec3d& place) {
  Terms terms;
  terms << second_degree(normal.cast<double>()), second_degree(place);
  return terms;
}

double log_luminance(const Vec3f& colour) {
  const float luminance = colour.dot(Vec3f(0.2126F, 0.7152F, 0.0722F));
  return std::log(std::max(luminance, kDarkest));
}

/// The areas of the triangles around each vertex, a third of each. Units: file units².
std::vector<double> vertex_areas(const PreparedMesh& prepared) {
  std::vector<double> areas(prepared.vertices.size(), 0);
  for (const Triangle& triangle : prepared.triangles) {
    const Vec3d& a = prepared.vertices[triangle[0]];
    const Vec3d sides =
        (prepared.vertices[triangle[1]] - a).cross(prepared.vertices[triangle[2]] - a);
    for (const uint32_t v : triangle) areas[v] += sides.norm() / 6;
  }
  return areas;
}

/// Sums what the vertices say about the light.
class LightFit {
 public:
  LightFit(const Multigrid& on, std::span<const Vec3f> fitted)
      : prepared_(*on.prepared),
        grid_(on.hierarchy->at(on.hierarchy->finest).grid),
        normals_(corner_normals(prepared_, grid_)),
        areas_(vertex_areas(prepared_)),
        half_side_(0.5 * std::ldexp(1.0, grid_.depth)) {
    find_means(fitted);
    find_slopes(fitted);
    find_target();
  }

  std::vector<CornerNumber> at_corners() const {
    const double most = std::log(kLightFactorMax);
    std::vector<CornerNumber> factors(normals_.size());
#pragma omp parallel for schedule(static)
    for (size_t corner = 0; corner < factors.size(); ++corner) {
      const double log_light =
          light_at(normals_[corner], morton_point(grid_.corners[corner].place).cast<double>());
      factors[corner](0) = static_cast<float>(std::clamp(target_ - log_light, -most, most));
    }
    return factors;
  }

 private:
  /// Calls use(area, normal, place in cells, point of the grid) for the vertices on the surface.
  template <typename Use>
  void each_vertex(const Use& use) const {
    const size_t stride = areas_.size() / kVerticesMax + 1;
    for (size_t v = 0; v < areas_.size(); v += stride) {
      const EvaluationPoint& at = prepared_.evaluation[v];
      if (at.cell == kNone || areas_[v] == 0) continue;
      const Vec3d place = prepared_.frame.to_grid(prepared_.vertices[v]);
      use(areas_[v], evaluate(grid_, at, std::span<const Vec3f>(normals_)), place, at);
    }
  }

  Terms centred(const Vec3f& normal, const Vec3d& place) const {
    return terms_at(normal, place / half_side_ - Vec3d::Ones()) - mean_terms_;
  }

  double light_at(const Vec3f& normal, const Vec3d& place) const {
    return mean_ + slopes_.dot(centred(normal, place));
  }

  void find_means(std::span<const Vec3f> fitted) {
    each_vertex([&](double area, const Vec3f& normal, const Vec3d& place, const auto& at) {
      area_ += area;
      sums_ += area * centred(normal, place);
      mean_ += area * log_luminance(evaluate(grid_, at, fitted));
    });
    mean_terms_ = sums_ / area_;
    mean_ /= area_;
  }

  void find_slopes(std::span<const Vec3f> fitted) {
    Eigen::Matrix<double, kTerms, kTerms> squares =
        kStiffness * area_ * Eigen::Matrix<double, kTerms, kTerms>::Identity();
    Terms right = Terms::Zero();
    each_vertex([&](double area, const Vec3f& normal, const Vec3d& place, const auto& at) {
      const Terms terms = centred(normal, place);
      squares += area * terms * terms.transpose();
      right += area * (log_luminance(evaluate(grid_, at, fitted)) - mean_) * terms;
    });
    slopes_ = squares.ldlt().solve(right);
  }

  // The mean is that of the light, not of its logarithm: the whole stays as bright as it was.
  void find_target() {
    double light = 0;
    each_vertex([&](double area, const Vec3f& normal, const Vec3d& place, const auto&) {
      light += area * std::exp(light_at(normal, place));
    });
    target_ = std::log(light / area_);
  }

  const PreparedMesh& prepared_;
  const SparseGrid& grid_;
  const std::vector<Vec3f> normals_;  // per corner
  const std::vector<double> areas_;   // per vertex
  const double half_side_;            // of the grid, cells
  double area_ = 0;
  Terms sums_ = Terms::Zero(), mean_terms_ = Terms::Zero(), slopes_ = Terms::Zero();
  double mean_ = 0;    // of the logarithm of the luminance
  double target_ = 0;  // the logarithm of the light's mean
};

}  // namespace

std::vector<CornerNumber> find_baked_light(const Multigrid& on, std::span<const Vec3f> fitted) {
  return LightFit(on, fitted).at_corners();
}

uint64_t predict_light_bytes(const Multigrid& on) {
  constexpr uint64_t kNormalBytes = 4 * sizeof(float);  // of corner_normals(), with the area
  const SparseGrid& grid = on.hierarchy->at(on.hierarchy->finest).grid;
  const uint64_t corners = grid.corners.size(), cells = grid.cells.size();
  return corners * (2 * sizeof(Vec3f) + sizeof(CornerNumber) + kNormalBytes) +
         cells * kNormalBytes + on.prepared->vertices.size() * sizeof(double);
}

}  // namespace burnish
