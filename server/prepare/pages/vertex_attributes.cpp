#include "server/prepare/pages/vertex_attributes.h"

#include <cmath>
#include <functional>
#include <utility>

#include "common/base/limits.h"
#include "common/mesh/corner_normals.h"
#include "server/prepare/pages/local_vertices.h"
#include "server/prepare/pages/page_work.h"
#include "server/prepare/radix_sort.h"

namespace burnish {

namespace {

struct SharedPlace {
  uint32_t vertex;
  uint64_t place;  // of its sum
};

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
                                      std::span<const uint8_t> shared, const ScratchSpace& space,
                                      const LoopPart& part) {
  VertexAttributes attributes;
  attributes.normals = ScratchArray<Vec3f>(space, scan.vertices.size());
  std::ranges::fill(attributes.normals, Vec3f::UnitZ());
  attributes.colours = copy_to(space, scan.colours);
  AttributeSums sums(shared, level.joined, space);
  std::vector<PageSums> of_batch(PageWork::kPagesPerBatch);
  const Status status = PageWork(part.progress, part.begin, part.end)
                            .run(
                                level.pages.count(),
                                [&](size_t page) {
                                  PageSums& made = of_batch[page % of_batch.size()];
                                  made = sum_scan_normals(scan.vertices, level, page);
                                  sums.set_own(made, attributes);
                                },
                                [&](size_t page) {
                                  sums.keep_shared(of_batch[page % of_batch.size()]);
                                  return Status::ok();
                                });
  if (!status.is_ok()) leave_cancelled_work();
  sums.set_shared(attributes, part);
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

void AttributeSums::set_own(const PageSums& sums, VertexAttributes& attributes) const {
  for (size_t i = 0; i < sums.vertices.size(); ++i)
    if (!is_shared(sums.vertices[i])) set(sums.vertices[i], sums.sums[i], attributes);
}

void AttributeSums::keep_shared(const PageSums& sums) {
  for (size_t i = 0; i < sums.vertices.size(); ++i)
    if (is_shared(sums.vertices[i])) of_shared_.push_back({sums.vertices[i], sums.sums[i]});
}

void AttributeSums::set_shared(VertexAttributes& attributes, const LoopPart& part) const {
  ScratchArray<SharedPlace> order(space_, of_shared_.size()), spare(space_, of_shared_.size());
  for (size_t i = 0; i < order.size(); ++i) order[i] = {of_shared_[i].vertex, i};
  radix_sort(std::span(order.data(), order.size()), std::span(spare.data(), spare.size()),
             std::mem_fn(&SharedPlace::vertex), part);
  AttributeSum total;
  for_each_heard(part, order.size(), [&](size_t i) {
    add(of_shared_[order[i].place].sum, total);
    if (i + 1 < order.size() && order[i + 1].vertex == order[i].vertex) return;
    set(order[i].vertex, std::exchange(total, {}), attributes);
  });
}

}  // namespace burnish
