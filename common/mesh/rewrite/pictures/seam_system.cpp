#include "common/mesh/rewrite/pictures/seam_system.h"

#include <algorithm>
#include <limits>
#include <string>

namespace burnish {

namespace {

// Each side between two triangles of a chart is visited from both.
constexpr double kAlike = 0.1 / 2;
constexpr double kStill = 1e-4;
constexpr double kResidualMax = 1e-4;  // of the right side
constexpr int kStepsMax = 3000;
constexpr uint64_t kEntriesPerSeam = 16;
constexpr Eigen::Index kBlock = 4096;  // of sums, whose order is fixed

/// Returns the dot product of each channel.
Eigen::Array3d dots(const SeamSystem::Values& a, const SeamSystem::Values& b) {
  const Eigen::Index blocks = (a.rows() + kBlock - 1) / kBlock;
  std::vector<Eigen::Array3d> sums(blocks);
#pragma omp parallel for schedule(static)
  for (Eigen::Index block = 0; block < blocks; ++block) {
    const Eigen::Index begin = block * kBlock, rows = std::min(kBlock, a.rows() - begin);
    sums[block] = a.middleRows(begin, rows).cwiseProduct(b.middleRows(begin, rows)).colwise().sum();
  }
  Eigen::Array3d sum = Eigen::Array3d::Zero();
  for (const Eigen::Array3d& one : sums) sum += one;
  return sum;
}

/// Returns a / b, or 0 where both are: that channel is solved.
Eigen::Array3d ratio(const Eigen::Array3d& a, const Eigen::Array3d& b) {
  return (b > 0).select(a / b, 0);
}

}  // namespace

SeamSystem::SeamSystem(const TextureCharts& charts)
    : charts_(&charts), right_(Values::Zero(charts.point_count(), 3)) {
  entries_.reserve(kEntriesPerSeam * charts.seams.size());
}

Result<SeamSystem> SeamSystem::make(const TextureCharts& charts) {
  constexpr uint64_t kSeamsMax = std::numeric_limits<int32_t>::max() / kEntriesPerSeam;
  if (charts.seams.size() <= kSeamsMax) return SeamSystem(charts);
  return resource_exhausted("the scan's pictures have " + std::to_string(charts.seams.size()) +
                            " seams; the limit is " + std::to_string(kSeamsMax));
}

uint64_t SeamSystem::bytes_of(const TextureCharts& charts) {
  constexpr uint64_t kVectors = 6;
  // The triplets, and the matrix that they become, twice while it is sorted.
  constexpr uint64_t kPerSeam = kEntriesPerSeam * (sizeof(Eigen::Triplet<double>) + 2 * 12);
  return kVectors * 3 * sizeof(double) * charts.point_count() + kPerSeam * charts.seams.size();
}

void SeamSystem::add(const Points& points, const Wishes& wishes) {
  for (Eigen::Index row = 0; row < 4; ++row) {
    right_.row(points[row]) += wishes.right_.row(row);
    for (Eigen::Index column = 0; column < 4; ++column)
      if (wishes.matrix_(row, column) != 0)
        entries_.emplace_back(static_cast<int32_t>(points[row]),
                              static_cast<int32_t>(points[column]), wishes.matrix_(row, column));
  }
}

void SeamSystem::multiply(const Values& x, Values& product) const {
#pragma omp parallel for schedule(static)
  for (Eigen::Index point = 0; point < x.rows(); ++point) {
    Eigen::RowVector3d sum = kStill * x.row(point);
    for (const uint32_t corner : charts_->corners_of(static_cast<uint32_t>(point))) {
      const uint32_t first = corner - corner % 3;
      for (uint32_t k = 1; k < 3; ++k)
        sum += kAlike * (x.row(point) - x.row(charts_->points[first + (corner + k) % 3]));
    }
    for (decltype(seams_)::InnerIterator entry(seams_, static_cast<int32_t>(point)); entry; ++entry)
      sum += entry.value() * x.row(entry.col());
    product.row(point) = sum;
  }
}

Eigen::VectorXd SeamSystem::diagonal() const {
  Eigen::VectorXd diagonal = seams_.diagonal();
  for (uint32_t point = 0; point < charts_->point_count(); ++point)
    diagonal[point] += kStill + 2 * kAlike * static_cast<double>(charts_->corners_of(point).size());
  return diagonal;
}

Result<SeamSystem::Values> SeamSystem::solve(const FileBudget& budget) {
  const auto points = static_cast<int32_t>(charts_->point_count());
  seams_.resize(points, points);
  seams_.setFromTriplets(entries_.begin(), entries_.end());
  entries_ = {};
  const Eigen::VectorXd inverse = diagonal().cwiseInverse();
  Values x = Values::Zero(points, 3), left = right_, product(points, 3);
  Values direction = inverse.asDiagonal() * left, scaled = direction;
  const Eigen::Array3d least = kResidualMax * kResidualMax * dots(right_, right_);
  Eigen::Array3d energy = dots(left, scaled);
  for (int step = 0; step < kStepsMax && (dots(left, left) > least).any(); ++step) {
    RETURN_IF_ERROR(hear(budget));
    multiply(direction, product);
    const Eigen::Array3d length = ratio(energy, dots(direction, product));
    x += direction * length.matrix().asDiagonal();
    left -= product * length.matrix().asDiagonal();
    scaled = inverse.asDiagonal() * left;
    const Eigen::Array3d next = dots(left, scaled);
    direction = scaled + direction * ratio(next, energy).matrix().asDiagonal();
    energy = next;
  }
  return x;
}

}  // namespace burnish
