#include "server/prepare/pages/draw_page.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "server/prepare/pages/local_vertices.h"

namespace burnish {

namespace {

void add_patches(const LevelToDraw& level, std::span<const uint32_t> triangles, Page& page) {
  for (const uint32_t t : triangles) {
    const PageId finer = level.finer.empty() ? kNoPage : level.finer[t];
    if (page.patches.empty() || page.patches.back().finer != finer) page.patches.push_back({finer});
    ++page.patches.back().triangles;
  }
}

// Numbers the vertices of the page: those of several pages first.
std::vector<uint16_t> border_first(std::span<const uint32_t> vertices, const LevelToDraw& level,
                                   uint32_t& border_vertices) {
  const auto is_border = [&](uint32_t v) { return level.shared[level.cut.joined[v]] != 0; };
  border_vertices = static_cast<uint32_t>(std::ranges::count_if(vertices, is_border));
  uint32_t border = 0, inside = border_vertices;
  std::vector<uint16_t> number;
  for (const uint32_t v : vertices)
    number.push_back(static_cast<uint16_t>(is_border(v) ? border++ : inside++));
  return number;
}

void add_vertices(const LevelToDraw& level, std::span<const uint32_t> vertices,
                  const std::vector<uint16_t>& number, Page& page) {
  const bool has_all_normals = !level.finer.empty();
  page.positions.resize(vertices.size());
  page.normals.resize(has_all_normals ? vertices.size() : page.border_vertices);
  if (!level.attributes.colours.empty()) page.colours.resize(vertices.size());
  for (size_t i = 0; i < vertices.size(); ++i) {
    const uint32_t v = vertices[i];
    page.positions[number[i]] = level.vertices.positions[v];
    if (number[i] < page.normals.size()) page.normals[number[i]] = level.attributes.normals[v];
    if (!page.colours.empty()) page.colours[number[i]] = level.attributes.colours[v];
  }
}

}  // namespace

Page draw_page(const LevelToDraw& level, size_t index, PageId id) {
  const std::span<const uint32_t> triangles = level.cut.pages[index];
  Page page;
  page.id = id;
  add_patches(level, triangles, page);
  LocalVertices locals;
  for (const uint32_t t : triangles)
    for (const uint32_t v : level.cut.triangles[t]) locals.add(v);
  const std::vector<uint16_t> number = border_first(locals.all(), level, page.border_vertices);
  add_vertices(level, locals.all(), number, page);
  page.triangles.reserve(triangles.size());
  for (const uint32_t t : triangles) {
    const Triangle& corners = level.cut.triangles[t];
    page.triangles.push_back({number[locals.add(corners[0])], number[locals.add(corners[1])],
                              number[locals.add(corners[2])]});
  }
  return page;
}

PageBounds sphere_around(const Page& page, const PageGrid& grid) {
  Vec3i low = page.positions[0], high = low;
  for (const Vec3i& p : page.positions) low = low.cwiseMin(p), high = high.cwiseMax(p);
  const auto place = [&](const Vec3d& steps) -> Vec3d {
    return (steps + Vec3d::Constant(0.5)) * grid.step();
  };
  PageBounds bounds;
  bounds.centre = place((low + high).cast<double>() / 2).cast<float>();
  double squared = 0;
  for (const Vec3i& p : page.positions)
    squared =
        std::max(squared, (place(p.cast<double>()) - bounds.centre.cast<double>()).squaredNorm());
  bounds.radius =
      std::nextafter(static_cast<float>(std::sqrt(squared)), std::numeric_limits<float>::max());
  return bounds;
}

float mean_edge(std::span<const Triangle> triangles, const PageVertices& vertices) {
  double sum = 0;
  for (const Triangle& t : triangles)
    for (int corner = 0; corner < 3; ++corner)
      sum += (vertices.positions[t[corner]] - vertices.positions[t[(corner + 1) % 3]])
                 .cast<double>()
                 .norm();
  return static_cast<float>(sum / (3.0 * static_cast<double>(triangles.size())) *
                            vertices.grid.step());
}

}  // namespace burnish
