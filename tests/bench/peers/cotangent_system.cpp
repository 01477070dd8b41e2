#include <cmath>

#include "tests/bench/peers/linear_system.h"

namespace burnish::bench {
namespace {

using Entry = Eigen::Triplet<double>;

class CotangentSystem final : public LinearSystem {
 public:
  explicit CotangentSystem(const TriangleMesh& mesh) {
    const auto n = static_cast<Eigen::Index>(mesh.vertices.size());
    std::vector<Entry> entries;
    entries.reserve(12 * mesh.triangles.size() + mesh.vertices.size());
    mass_.setZero(n);
    double area = 0;
    for (const Triangle& triangle : mesh.triangles) area += add(mesh, triangle, entries);
    // A vertex without surface keeps its place: its row is 1 · u = 0.
    for (Eigen::Index v = 0; v < n; ++v)
      if (!(mass_[v] > 0)) entries.emplace_back(v, v, 1.0);
    stiffness_.resize(n, n);
    stiffness_.setFromTriplets(entries.begin(), entries.end());
    length_unit_ = std::sqrt(area);

    MatrixXd positions(n, 3);
    for (Eigen::Index v = 0; v < n; ++v) positions.row(v) = mesh.vertices[v];
    gradient_ = stiffness_ * positions;
    for (Eigen::Index v = 0; v < n; ++v)
      if (!(mass_[v] > 0)) gradient_.row(v).setZero();
  }

  SparseMatrix matrix(double alpha) const override {
    SparseMatrix sum = stiffness_;
    sum.diagonal() += (alpha / length_unit_) * (alpha / length_unit_) * mass_;
    return sum;
  }

  MatrixXd vertex_moves(const MatrixXd& x) const override { return x; }

  uint64_t byte_count() const override {
    return byte_count_of(stiffness_) + byte_count_of(mass_) + byte_count_of(gradient_);
  }

 private:
  /// Returns the triangle's area.
  double add(const TriangleMesh& mesh, const Triangle& triangle, std::vector<Entry>& entries) {
    const auto point = [&](int corner) -> const Vec3d& {
      return mesh.vertices[triangle[corner % 3]];
    };
    const double twice_area = (point(1) - point(0)).cross(point(2) - point(0)).norm();
    if (!(twice_area > 0)) return 0;
    for (int corner = 0; corner < 3; ++corner) {
      const Vec3d& apex = point(corner);
      const uint32_t i = triangle[(corner + 1) % 3];
      const uint32_t j = triangle[(corner + 2) % 3];
      const double weight =
          0.5 * (point(corner + 1) - apex).dot(point(corner + 2) - apex) / twice_area;
      entries.emplace_back(i, j, -weight);
      entries.emplace_back(j, i, -weight);
      entries.emplace_back(i, i, weight);
      entries.emplace_back(j, j, weight);
      mass_[triangle[corner]] += twice_area / 6;
    }
    return twice_area / 2;
  }

  SparseMatrix stiffness_;
  Eigen::VectorXd mass_;
  double length_unit_ = 1;
};

}  // namespace

std::unique_ptr<LinearSystem> make_cotangent_system(const TriangleMesh& mesh) {
  return std::make_unique<CotangentSystem>(mesh);
}

}  // namespace burnish::bench
