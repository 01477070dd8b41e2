#include "tests/client/pages/synthetic_scan.h"

#include <algorithm>
#include <cmath>

#include "common/generate/noise.h"

namespace burnish {

namespace {

using Box = Eigen::AlignedBox2d;

constexpr double kBytesPerTriangle = 2.7;
constexpr double kVerticesPerTriangle = 0.54;

double area_where_they_meet(const Box& one, const Box& other) {
  const Box common = one.intersection(other);
  return common.isEmpty() ? 0 : common.volume();
}

// Lines of `count` columns over 0..1, moved by a part of a column; a single column stays whole.
std::vector<double> lines_of(int count, double moved) {
  std::vector<double> lines = {0};
  if (count > 1)
    for (int i = 0; i < count; ++i) lines.push_back((i + moved) / count);
  lines.push_back(1);
  return lines;
}

std::vector<Box> rectangles_of(int columns, int rows, double moved) {
  const std::vector<double> x = lines_of(columns, moved), y = lines_of(rows, moved);
  std::vector<Box> made;
  for (size_t row = 0; row + 1 < y.size(); ++row)
    for (size_t column = 0; column + 1 < x.size(); ++column)
      made.emplace_back(Eigen::Vector2d(x[column], y[row]),
                        Eigen::Vector2d(x[column + 1], y[row + 1]));
  // Neighbours together, as in the order of Morton: 16 stripes of rows, each by columns.
  std::ranges::stable_sort(made, {}, [](const Box& box) {
    return std::pair(static_cast<int>(box.center().y() * 16), box.center().x());
  });
  return made;
}

class Builder {
 public:
  explicit Builder(const SyntheticScanOptions& options) : options_(options) {}

  SyntheticScan build() {
    add_level_zero();
    for (int level = 1; level_end() - level_begin_ > 1; ++level) add_level(level);
    finish();
    return std::move(scan_);
  }

 private:
  PageId level_end() const { return static_cast<PageId>(scan_.places.size()); }
  double jitter(PageId page) const { return 0.75 + 0.5 * uniform(options_.seed, page); }

  void add_level_zero() {
    for (const Box& box : rectangles_of(options_.side, options_.side, 0.5)) {
      const PageId page = level_end();
      const double part = box.volume() * options_.side * options_.side;
      const double wanted = part * options_.triangles_per_page * jitter(page);
      scan_.patches.add(
          std::vector<PagePatch>{{kNoPage, static_cast<uint32_t>(std::max(2.0, wanted))}});
      add_page(box, 0, 0);
    }
    scan_.directory.head.level_pages.push_back(level_end());
  }

  void add_level(int level) {
    const PageId finer_begin = level_begin_;
    level_begin_ = level_end();
    const int columns = std::max(1, options_.side >> ((level + 1) / 2));
    const int rows = std::max(1, options_.side >> (level / 2));
    const double moved = 0.2 + 0.6 * uniform(options_.seed + 1, level);
    for (const Box& box : rectangles_of(columns, rows, moved))
      add_coarser(box, finer_begin, level_begin_);
    scan_.directory.head.level_pages.push_back(level_end() - level_begin_);
  }

  void add_coarser(const Box& box, PageId begin, PageId end) {
    std::vector<PagePatch> patches;
    float error = 0, edge = 0;
    for (PageId finer = begin; finer < end; ++finer) {
      if (!box.intersects(scan_.places[finer])) continue;
      const double common = area_where_they_meet(box, scan_.places[finer]);
      if (common <= 0) continue;
      const PageEntry& entry = scan_.directory.entries[finer];
      const double part = common / scan_.places[finer].volume();
      patches.push_back(
          {finer, static_cast<uint32_t>(std::max(1.0, std::round(part * entry.triangles / 2)))});
      error = std::max(error, entry.bounds.error);
      edge = std::max(edge, entry.bounds.edge);
    }
    scan_.patches.add(patches);
    add_page(box, error, edge);
  }

  // The error and the edges of what replaces the page are larger than the page's own.
  void add_page(const Box& box, float error_min, float edge_min) {
    uint32_t triangles = 0;
    for (const PagePatch& patch : scan_.patches[level_end()]) triangles += patch.triangles;
    PageEntry entry;
    entry.triangles = static_cast<uint16_t>(triangles);
    entry.vertices = static_cast<uint16_t>(kVerticesPerTriangle * triangles + 3);
    entry.bytes = static_cast<uint32_t>(kBytesPerTriangle * triangles + 48);
    const double edge = std::sqrt(2 * 2 * box.volume() / triangles);  // of half the triangles
    entry.bounds.centre = {static_cast<float>(box.center().x()),
                           static_cast<float>(box.center().y()), 0.5f};
    entry.bounds.radius = static_cast<float>(0.5 * box.diagonal().norm());
    entry.bounds.edge = std::max(edge_min, static_cast<float>(edge));
    entry.bounds.error =
        std::max(error_min, static_cast<float>(0.05 * edge * jitter(level_end() + 7)));
    scan_.directory.entries.push_back(entry);
    scan_.places.push_back(box);
  }

  void finish() {
    PageDirectory& directory = scan_.directory;
    directory.coarser = group_by<PageId>(directory.entries.size(), [&](auto&& add) {
      for (PageId page = 0; page < directory.entries.size(); ++page)
        for (const PagePatch& patch : scan_.patches[page])
          if (patch.finer != kNoPage) add(patch.finer, page);
    });
    PageHead& head = directory.head;
    head.grid.origin = {100, 200, -50};
    for (PageId page = 0; page < head.level_pages[0]; ++page)
      head.scan_triangles += directory.entries[page].triangles;
    head.scan_vertices = head.scan_triangles / 2;
    for (const PageEntry& entry : directory.entries) head.page_bytes += entry.bytes;
    for (uint32_t block = 0; block < head.block_count(); ++block) add_block(block);
  }

  void add_block(uint32_t block) {
    const PageRange pages = scan_.directory.head.pages_of(block);
    Eigen::AlignedBox2d box;
    PageBlock made;
    for (PageId page = pages.begin; page < pages.end; ++page) {
      const PageBounds& bounds = scan_.directory.entries[page].bounds;
      box.extend(scan_.places[page]);
      made.bounds.error = std::max(made.bounds.error, bounds.error);
      made.bounds.edge = std::max(made.bounds.edge, bounds.edge);
    }
    made.bounds.centre = {static_cast<float>(box.center().x()),
                          static_cast<float>(box.center().y()), 0.5f};
    for (PageId page = pages.begin; page < pages.end; ++page) {
      const PageBounds& bounds = scan_.directory.entries[page].bounds;
      made.bounds.radius =
          std::max(made.bounds.radius, (bounds.centre - made.bounds.centre).norm() + bounds.radius);
    }
    made.bytes = 26 * pages.count() + 32;
    scan_.directory.head.blocks.push_back(made);
  }

  SyntheticScanOptions options_;
  SyntheticScan scan_;
  PageId level_begin_ = 0;
};

}  // namespace

SyntheticScan make_synthetic_scan(const SyntheticScanOptions& options) {
  return Builder(options).build();
}

Camera camera_over(double x, double y, double distance) {
  Camera camera;
  camera.target = Vec3d(100 + x, 200 + y, -49.5);
  camera.distance = distance;
  camera.scene_radius = 2;
  return camera;
}

Page SyntheticScan::page(PageId id) const {
  Page page;
  page.id = id;
  page.patches.assign(patches[id].begin(), patches[id].end());
  page.triangles.resize(directory.entries[id].triangles);
  page.positions.resize(directory.entries[id].vertices);
  page.normals.resize(directory.entries[id].vertices);
  return page;
}

DirectoryBlock SyntheticScan::block(uint32_t index) const {
  const PageRange pages = directory.head.pages_of(index);
  DirectoryBlock block;
  block.begin = pages.begin;
  for (PageId page = pages.begin; page < pages.end; ++page) {
    block.entries.push_back(directory.entries[page]);
    block.coarser.add(directory.coarser[page]);
  }
  return block;
}

double SyntheticScan::drawn_area(const PageSet& set) const {
  double area = 0;
  for (PageId page = 0; page < set.size(); ++page)
    for (const PagePatch& patch : patches[page])
      if (set[page] != 0 && is_drawn(patch, set))
        area += patch.finer == kNoPage ? places[page].volume()
                                       : area_where_they_meet(places[page], places[patch.finer]);
  return area;
}

uint64_t SyntheticScan::drawn_triangles(const PageSet& set) const {
  uint64_t triangles = 0;
  for (PageId page = 0; page < set.size(); ++page)
    for (const PagePatch& patch : patches[page])
      if (set[page] != 0 && is_drawn(patch, set)) triangles += patch.triangles;
  return triangles;
}

}  // namespace burnish
