#include "server/prepare/pages/vertex_attributes.h"

#include <cmath>
#include <unordered_map>

#include "common/base/limits.h"
#include "common/base/parallel.h"
#include "common/mesh/corner_normals.h"
#include "server/prepare/pages/local_vertices.h"

namespace burnish {

namespace {

void add(const AttributeSum& term, AttributeSum& sum) {
  sum.normal += term.normal;
  for (int i = 0; i < 4; ++i) sum.colour[i] += term.colour[i];
  sum.weight += term.weight;
}

double area_of(const Triangle& t, std::span<const Vec3i> positions) {
  const Vec3d a = positions[t[0]].cast<double>();
  const Vec3d b = positions[t[1]].cast<double>(), c = positions[t[2]].cast<double>();
  return (b - a).cross(c - a).norm() / 2;
}

// Returns the mean of a triangle's corners times its area.
AttributeSum term_of(const Triangle& t, const VertexAttributes& attributes, double area) {
  AttributeSum term;
  for (const uint32_t v : t) {
    term.normal += attributes.normals[v].cast<double>() * (area / 3);
    if (attributes.colours.empty()) continue;
    for (int i = 0; i < 4; ++i) term.colour[i] += attributes.colours[v][i] * (area / 3);
  }
  term.weight = area;
  return term;
}

// Leaves an attribute as it is where the triangles have no area or their normals cancel out.
void set(uint32_t vertex, const AttributeSum& sum, VertexAttributes& attributes) {
  const double length = sum.normal.norm();
  if (length > 0) attributes.normals[vertex] = (sum.normal / length).cast<float>();
  if (attributes.colours.empty() || !(sum.weight > 0)) return;
  for (int i = 0; i < 4; ++i)
    attributes.colours[vertex][i] = static_cast<uint8_t>(std::lround(sum.colour[i] / sum.weight));
}

// Sums the normals of a page's triangles at the vertices of the scan, as corner_normals() does.
PageSums sum_scan_normals(std::span<const Vec3d> vertices, const CutLevel& level,
                          size_t page_index) {
  LocalVertices locals;
  PageSums page;
  page.sums.resize(kPageVerticesMax);
  for (const uint32_t t : level.pages[page_index]) {
    const Triangle& triangle = level.triangles[t];
    std::array<Vec3d, 3> corners;
    for (int i = 0; i < 3; ++i) corners[i] = vertices[triangle[i]];
    const auto normals = corner_normals(corners[0], corners[1], corners[2]);
    for (int i = 0; i < 3; ++i) page.sums[locals.add(triangle[i])].normal += normals[i];
  }
  page.vertices.assign(locals.all().begin(), locals.all().end());
  return page;
}

}  // namespace

VertexAttributes make_scan_attributes(const PagesInput& scan, const CutLevel& level,
                                      std::span<const uint8_t> shared) {
  VertexAttributes attributes;
  attributes.normals.assign(scan.vertices.size(), Vec3f::UnitZ());
  AttributeSums sums(shared, level.joined, level.pages.count());
  ParallelFailure failure;
#pragma omp parallel for schedule(dynamic)
  for (size_t page = 0; page < level.pages.count(); ++page)
    failure.run([&] { sums.take(page, sum_scan_normals(scan.vertices, level, page), attributes); });
  failure.rethrow();
  sums.set_shared(attributes);
  attributes.colours.assign(scan.colours.begin(), scan.colours.end());
  return attributes;
}

PageSums sum_page(const CutLevel& level, const VertexAttributes& attributes,
                  std::span<const Vec3i> positions, size_t page_index) {
  LocalVertices locals;
  PageSums page;
  page.sums.resize(kPageVerticesMax);
  for (const uint32_t t : level.pages[page_index]) {
    const Triangle& triangle = level.triangles[t];
    const AttributeSum term = term_of(triangle, attributes, area_of(triangle, positions));
    for (const uint32_t v : triangle) add(term, page.sums[locals.add(level.joined[v])]);
  }
  page.vertices.assign(locals.all().begin(), locals.all().end());
  return page;
}

void AttributeSums::take(size_t page, const PageSums& sums, VertexAttributes& attributes) {
  for (size_t i = 0; i < sums.vertices.size(); ++i) {
    const uint32_t vertex = sums.vertices[i];
    if (!shared_[joined_[vertex]]) {
      set(vertex, sums.sums[i], attributes);
    } else {
      of_pages_[page].vertices.push_back(vertex);
      of_pages_[page].sums.push_back(sums.sums[i]);
    }
  }
}

void AttributeSums::set_shared(VertexAttributes& attributes) const {
  std::unordered_map<uint32_t, AttributeSum> total;
  for (const PageSums& page : of_pages_)
    for (size_t i = 0; i < page.vertices.size(); ++i) add(page.sums[i], total[page.vertices[i]]);
  for (const auto& [vertex, sum] : total) set(vertex, sum, attributes);
}

}  // namespace burnish
