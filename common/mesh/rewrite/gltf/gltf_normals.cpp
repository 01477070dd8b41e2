#include "common/mesh/rewrite/gltf/gltf_normals.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include <Eigen/Geometry>

#include "common/mesh/rewrite/moved/moved_normals.h"

namespace burnish {

namespace {

std::array<Vec3d, 3> corners_of(std::span<const Vec3d> positions, const Triangle& triangle) {
  return {positions[triangle[0]], positions[triangle[1]], positions[triangle[2]]};
}

class GltfNormals {
 public:
  GltfNormals(const GltfSurface& surface, std::span<const Vec3d> before,
              std::span<const Vec3d> after, GltfColumns& columns)
      : surface_(surface), before_(before), after_(after), columns_(columns) {}

  void turn() {
    areas_.resize(columns_.all.size());
    for (size_t p = 0; p < surface_.parts.size(); ++p)
      if (columns_.normals[p]) gather(surface_.parts[p], *columns_.normals[p]);
    list_elements();
    for (size_t begin = 0; begin < elements_.size();) {
      size_t end = begin;
      while (end < elements_.size() && elements_[end].vertex == elements_[begin].vertex) ++end;
      turn_at_place(std::span(elements_).subspan(begin, end - begin));
      begin = end;
    }
  }

 private:
  /// An element of a column of normals.
  struct Element {
    uint32_t vertex = 0;
    uint32_t column = 0;
    uint32_t number = 0;
  };

  /// A direction at a place, and the triangles around it.
  struct Direction {
    Vec3d normal;  // in the scene, of length 1
    AreaVectors area;
  };

  void gather(const GltfPart& part, size_t column) {
    std::vector<AreaVectors>& areas = areas_[column];
    areas.resize(columns_.all[column].values.size());
    size_t triangle = part.first_triangle;
    for_each_triangle(*part.primitive, [&](uint32_t a, uint32_t b, uint32_t c) {
      const Triangle& t = surface_.mesh.triangles[triangle++];
      AreaVectors area;
      area.add(corners_of(before_, t), corners_of(after_, t));
      for (const uint32_t corner : {a, b, c}) {
        areas[corner].before += area.before;
        areas[corner].after += area.after;
      }
    });
  }

  void list_elements() {
    for (size_t c = 0; c < areas_.size(); ++c) {
      const std::vector<uint32_t>& vertices = surface_.points[columns_.all[c].points].vertices;
      for (size_t i = 0; i < areas_[c].size(); ++i)
        if (vertices[i] != kNoVertex)
          elements_.push_back({vertices[i], static_cast<uint32_t>(c), static_cast<uint32_t>(i)});
    }
    std::ranges::sort(elements_, {},
                      [](const Element& e) { return std::tuple(e.vertex, e.column, e.number); });
  }

  const Eigen::Affine3d& transform_of(const Element& element) const {
    const size_t points = columns_.all[element.column].points;
    return surface_.placements[surface_.points[points].placement].to_scene;
  }

  /// Returns a normal in the scene, of length 1 or 0.
  Vec3d normal_in_scene(const Element& element) const {
    const Vec3d local = columns_.all[element.column].values[element.number].cast<double>();
    const Vec3d normal = transform_of(element).linear().inverse().transpose() * local;
    return normal.allFinite() ? Vec3d(normal.stableNormalized()) : Vec3d(Vec3d::Zero());
  }

  /// Returns the direction that a normal belongs to. A hostile file has many at one place; those
  /// beyond the limit stay alone.
  Direction& find_direction(const Vec3d& normal) {
    constexpr size_t kDirectionsMax = 16;
    constexpr double kSameCosine = 1 - 1e-5;
    for (size_t d = 0; d < std::min(kDirectionsMax, directions_.size()); ++d)
      if (directions_[d].normal.dot(normal) > kSameCosine) return directions_[d];
    return directions_.emplace_back(Direction{normal, {}});
  }

  void turn_at_place(std::span<const Element> elements) {
    directions_.clear();
    std::vector<size_t> direction_of;
    for (const Element& element : elements) {
      Direction& direction = find_direction(normal_in_scene(element));
      const AreaVectors& area = areas_[element.column][element.number];
      direction.area.before += area.before;
      direction.area.after += area.after;
      direction_of.push_back(static_cast<size_t>(&direction - directions_.data()));
    }
    for (size_t e = 0; e < elements.size(); ++e)
      turn_element(elements[e], directions_[direction_of[e]]);
  }

  void turn_element(const Element& element, const Direction& direction) {
    GltfColumn& column = columns_.all[element.column];
    const Vec3d turned = direction.area.turn(direction.normal);
    if (turned == direction.normal) return;
    Vec3f& value = column.values[element.number];
    const double norm = value.cast<double>().norm();
    const Vec3d local = transform_of(element).linear().transpose() * turned;
    const double length = std::abs(norm - 1) < 0.01 ? 1 : norm;
    const Vec3f normal = (length * local.stableNormalized() + Vec3d::Zero()).cast<float>();
    column.is_changed |= normal != value;
    value = normal;
  }

  const GltfSurface& surface_;
  std::span<const Vec3d> before_;
  std::span<const Vec3d> after_;
  GltfColumns& columns_;
  std::vector<std::vector<AreaVectors>> areas_;  // by column; empty for positions
  std::vector<Element> elements_;
  std::vector<Direction> directions_;  // of one place
};

}  // namespace

void turn_normals(const GltfSurface& surface, std::span<const Vec3d> before,
                  std::span<const Vec3d> after, GltfColumns& columns) {
  GltfNormals(surface, before, after, columns).turn();
}

}  // namespace burnish
