#include "server/session/mesh_signal.h"

#include <algorithm>
#include <cmath>

#include "common/base/blocks.h"
#include "common/grid/sparse_grid.h"
#include "common/mesh/joined_mesh.h"

namespace burnish {

namespace {

/// Twice the area of a triangle over the square of its longest edge; flatter ones have no area.
constexpr double kFlatness = 1e-12;

struct Largest {
  float value = 0;
  Largest& operator+=(const Largest& other) {
    value = std::max(value, other.value);
    return *this;
  }
};

}  // namespace

MeshSignal::MeshSignal(const PreparedMesh& prepared, std::span<const Vec3f> values)
    : prepared_(prepared),
      place_(least_at_places(prepared.vertices)),
      elements_(prepared.triangles.size()),
      values_(place_.size(), Vec3f::Zero()),
      inverse_diagonal_(place_.size()),
      solution_(place_.size()),
      residual_(place_.size()),
      direction_(place_.size()),
      product_(place_.size()) {
#pragma omp parallel for schedule(static)
  for (size_t t = 0; t < elements_.size(); ++t) {
    const auto corner = [&](int i) {
      return prepared.frame.to_grid(prepared.vertices[prepared.triangles[t][i]]);
    };
    elements_[t] = element_of(corner(0), corner(1), corner(2));
  }
  around_ = group_by<uint32_t, int64_t>(place_.size(), [&](auto&& add) {
    for (uint32_t t = 0; t < elements_.size(); ++t)
      if (elements_[t].area > 0)
        for (const uint32_t node : nodes_of(t)) add(node, t);
  });
  std::vector<uint32_t> vertices(place_.size(), 0);
  for (size_t v = 0; v < place_.size(); ++v) {
    values_[place_[v]] += values[v];
    ++vertices[place_[v]];
  }
  for (size_t v = 0; v < place_.size(); ++v)
    if (vertices[v] > 1) values_[v] /= static_cast<float>(vertices[v]);
}

// The triangle lies in a plane of its own, with a in the origin and b on the first axis.
MeshSignal::Element MeshSignal::element_of(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  const Vec3d ab = b - a, ac = c - a;
  const double width = ab.norm(), twice_area = ab.cross(ac).norm();
  const double longest = std::max({ab.squaredNorm(), ac.squaredNorm(), (c - b).squaredNorm()});
  if (!(twice_area > kFlatness * longest)) return {};
  const double height = twice_area / width, foot = ab.dot(ac) / width;
  const double scale = std::sqrt(twice_area / 2) / twice_area;
  Element element;
  element.hat[0] = (scale * Eigen::Vector2d(-height, foot - width)).cast<float>();
  element.hat[1] = (scale * Eigen::Vector2d(height, -foot)).cast<float>();
  element.area = static_cast<float>(twice_area / 2);
  return element;
}

std::array<uint32_t, 3> MeshSignal::nodes_of(uint32_t triangle) const {
  const Triangle& t = prepared_.triangles[triangle];
  return {place_[t[0]], place_[t[1]], place_[t[2]]};
}

MeshSignal::Slopes MeshSignal::slopes(uint32_t triangle, std::span<const Vec3f> values) const {
  const Element& element = elements_[triangle];
  const auto [a, b, c] = nodes_of(triangle);
  return element.hat[0] * (values[a] - values[c]).transpose() +
         element.hat[1] * (values[b] - values[c]).transpose();
}

MeshSignal::Slope MeshSignal::hat(uint32_t triangle, int corner) const {
  const Element& element = elements_[triangle];
  return corner < 2 ? element.hat[corner] : Slope(-element.hat[0] - element.hat[1]);
}

static int corner_of(const std::array<uint32_t, 3>& nodes, uint32_t node) {
  return nodes[0] == node ? 0 : nodes[1] == node ? 1 : 2;
}

Vec3f MeshSignal::row_times(uint32_t node, std::span<const Vec3f> values) const {
  const auto mass_scale = static_cast<float>(square_alpha_ / 12);
  Vec3f product = Vec3f::Zero();
  for (const uint32_t t : around_[node]) {
    const auto nodes = nodes_of(t);
    const Vec3f sum = values[nodes[0]] + values[nodes[1]] + values[nodes[2]] + values[node];
    product += mass_scale * elements_[t].area * sum +
               slopes(t, values).transpose() * hat(t, corner_of(nodes, node));
  }
  return product;
}

Vec3f MeshSignal::right_side(uint32_t node, std::span<const float> beta_above_one) const {
  Vec3f sum = Vec3f::Zero();
  for (const uint32_t t : around_[node]) {
    float above = 0;
    for (const uint32_t v : prepared_.triangles[t])
      if (const int32_t cell = prepared_.evaluation[v].cell; cell != kNone)
        above += beta_above_one[cell] / 3;
    if (above != 0)
      sum += above * slopes(t, values_).transpose() * hat(t, corner_of(nodes_of(t), node));
  }
  return sum;
}

float MeshSignal::diagonal(uint32_t node) const {
  const auto mass_scale = static_cast<float>(square_alpha_ / 6);
  float sum = 0;
  for (const uint32_t t : around_[node])
    sum += mass_scale * elements_[t].area + hat(t, corner_of(nodes_of(t), node)).squaredNorm();
  return sum;
}

void MeshSignal::begin(double alpha, std::span<const float> beta_above_one,
                       std::span<const Vec3f> change) {
  const double alpha_in_grid = alpha * prepared_.alpha_scale();
  square_alpha_ = alpha_in_grid * alpha_in_grid;
  solution_.assign(change.begin(), change.end());
  for_each_block(count(), [&](int32_t begin, int32_t end) {
    for (int32_t i = begin; i < end; ++i) {
      const auto node = static_cast<uint32_t>(i);
      const float sum = diagonal(node);
      inverse_diagonal_[i] = sum > 0 ? 1 / sum : 0;
      residual_[i] = right_side(node, beta_above_one) - row_times(node, solution_);
      direction_[i].setZero();
    }
  });
  energy_ = 0;
}

double MeshSignal::residual_energy() const {
  return ordered_sum<double>(count(), [&](int32_t begin, int32_t end) {
    double sum = 0;
    for (int32_t i = begin; i < end; ++i)
      sum += double{inverse_diagonal_[i]} * residual_[i].squaredNorm();
    return sum;
  });
}

float MeshSignal::step() {
  const double energy = residual_energy();
  if (!(energy > 0)) return 0;
  const auto kept = static_cast<float>(energy_ > 0 ? energy / energy_ : 0);
  energy_ = energy;
  for_each_block(count(), [&](int32_t begin, int32_t end) {
    for (int32_t i = begin; i < end; ++i)
      direction_[i] = inverse_diagonal_[i] * residual_[i] + kept * direction_[i];
  });
  const double curved = ordered_sum<double>(count(), [&](int32_t begin, int32_t end) {
    double sum = 0;
    for (int32_t i = begin; i < end; ++i) {
      product_[i] = row_times(static_cast<uint32_t>(i), direction_);
      sum += product_[i].dot(direction_[i]);
    }
    return sum;
  });
  if (!(curved > 0)) return 0;
  const auto length = static_cast<float>(energy / curved);
  return ordered_sum<Largest>(count(),
                              [&](int32_t begin, int32_t end) {
                                Largest largest;
                                for (int32_t i = begin; i < end; ++i) {
                                  solution_[i] += length * direction_[i];
                                  residual_[i] -= length * product_[i];
                                  largest += {length * direction_[i].norm()};
                                }
                                return largest;
                              })
      .value;
}

std::vector<Vec3f> MeshSignal::change() const {
  std::vector<Vec3f> change(place_.size());
#pragma omp parallel for schedule(static)
  for (size_t v = 0; v < change.size(); ++v) change[v] = solution_[place_[v]];
  return change;
}

uint64_t MeshSignal::byte_count() const {
  return elements_.size() * sizeof(Element) + around_.byte_count() +
         place_.size() * (sizeof(uint32_t) + sizeof(float) + 5 * sizeof(Vec3f));
}

uint64_t predict_mesh_signal_bytes(const PreparedMesh& prepared) {
  constexpr uint64_t kPlaceBytes = 9;  // while least_at_places() looks for them
  constexpr uint64_t kOfVertex =
      2 * sizeof(uint32_t) + sizeof(float) + 6 * sizeof(Vec3f) + sizeof(int64_t) + kPlaceBytes;
  constexpr uint64_t kOfTriangle = 5 * sizeof(float) + 3 * sizeof(uint32_t);
  return prepared.vertices.size() * kOfVertex + prepared.triangles.size() * kOfTriangle;
}

}  // namespace burnish
