#include "tests/common/page_frames/small_pages.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "common/generate/generate.h"
#include "common/page_frames/page_corners.h"

namespace burnish {

namespace {

constexpr int kSmallDepth = 5;
constexpr int kSmallBits = 14;
constexpr size_t kTrianglesPerPage = 300;
constexpr size_t kFinePerCoarse = 4;

bool before(const Vec3i& a, const Vec3i& b) {
  return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
}

Page page_of(PageId id, std::vector<Vec3i> positions) {
  std::ranges::sort(positions, before);
  positions.erase(std::ranges::unique(positions).begin(), positions.end());
  Page page;
  page.id = id;
  page.positions = std::move(positions);
  return page;
}

void add_triangle(const std::array<Vec3i, 3>& corners, Page& page) {
  PageTriangle triangle;
  for (int k = 0; k < 3; ++k)
    triangle[k] = static_cast<uint16_t>(
        std::ranges::lower_bound(page.positions, corners[k], before) - page.positions.begin());
  page.triangles.push_back(triangle);
}

// Cuts the triangles, in the order of their Morton keys, into runs.
void cut_fine_pages(const TriangleMesh& mesh, SmallPages& small) {
  std::vector<std::pair<MortonKey, size_t>> order;
  for (size_t t = 0; t < mesh.triangles.size(); ++t)
    order.emplace_back(morton_key(small.lattice.quantise(mesh.vertices[mesh.triangles[t][0]])), t);
  std::ranges::sort(order);
  for (size_t begin = 0; begin < order.size(); begin += kTrianglesPerPage) {
    std::vector<std::array<Vec3i, 3>> triangles;
    std::vector<Vec3i> positions;
    for (size_t i = begin; i < std::min(begin + kTrianglesPerPage, order.size()); ++i) {
      std::array<Vec3i, 3> corners;
      for (int k = 0; k < 3; ++k)
        corners[k] = small.lattice.quantise(mesh.vertices[mesh.triangles[order[i].second][k]]);
      triangles.push_back(corners);
      positions.insert(positions.end(), corners.begin(), corners.end());
    }
    small.pages.push_back(page_of(static_cast<PageId>(small.pages.size()), positions));
    for (const auto& corners : triangles) add_triangle(corners, small.pages.back());
  }
}

// Each coarse page has every fourth vertex of a few fine ones.
void cut_coarse_pages(SmallPages& small) {
  const size_t fine = small.pages.size();
  for (size_t begin = 0; begin < fine; begin += kFinePerCoarse) {
    std::vector<Vec3i> positions;
    for (size_t page = begin; page < std::min(begin + kFinePerCoarse, fine); ++page)
      for (size_t v = 0; v < small.pages[page].positions.size(); v += 4)
        positions.push_back(small.pages[page].positions[v]);
    small.pages.push_back(page_of(static_cast<PageId>(small.pages.size()), positions));
  }
}

SmallPages make_small_pages() {
  const TriangleMesh mesh = generate_scan({.kind = "blob", .vertices = 4000}).value();
  Vec3d least = mesh.vertices[0], greatest = mesh.vertices[0];
  for (const Vec3d& vertex : mesh.vertices) {
    least = least.cwiseMin(vertex);
    greatest = greatest.cwiseMax(vertex);
  }
  SmallPages small;
  small.lattice = {least, 1.01 * (greatest - least).maxCoeff(), kSmallBits};
  cut_fine_pages(mesh, small);
  cut_coarse_pages(small);
  std::set<MortonKey> cells;
  for (const Page& page : small.pages)
    for (const Vec3i& position : page.positions)
      cells.insert(morton_key(cell_place(position, kSmallBits, kSmallDepth).cell));
  small.grid = make_finest_grid(kSmallDepth, std::vector<MortonKey>(cells.begin(), cells.end()));
  return small;
}

}  // namespace

const SmallPages& small_pages() {
  static const SmallPages small = make_small_pages();
  return small;
}

std::vector<Vec3f> wavy_field(double amplitude, double phase) {
  std::vector<Vec3f> field;
  for (const GridKey& corner : small_pages().grid.corners) {
    const Vec3d p = morton_point(corner.place).cast<double>();
    const Vec3d wave(std::sin(0.3 * p.x() + phase), std::cos(0.2 * p.y() - phase),
                     std::sin(0.25 * (p.x() + p.z()) + phase));
    field.emplace_back((amplitude * wave).cast<float>());
  }
  return field;
}

void dab_field(std::mt19937& random, double amplitude, std::vector<Vec3f>& field) {
  constexpr int kReach = 2;
  const auto& corners = small_pages().grid.corners;
  const Vec3i middle = morton_point(corners[random() % corners.size()].place);
  std::uniform_real_distribution<double> change(-amplitude, amplitude);
  for (size_t i = 0; i < corners.size(); ++i)
    if ((morton_point(corners[i].place) - middle).cwiseAbs().maxCoeff() <= kReach)
      field[i] += Vec3d(change(random), change(random), change(random)).cast<float>();
}

PageSampler::PageSampler(PageFrameKind kind) : kind_(kind) {
  const SmallPages& small = small_pages();
  for (const Page& page : small.pages)
    evaluations_.push_back(std::make_shared<PageEvaluation>(
        make_page_evaluation(page, small.lattice.bits, small.grid, kind)));
  sample(std::vector<Vec3f>(small.grid.corners.size(), Vec3f::Zero()));
}

PageChange PageSampler::adding(uint32_t revision, const std::vector<PageId>& pages) const {
  PageChange change{.revision = revision};
  for (const PageId page : pages) change.added.push_back(shown(page));
  return change;
}

void PageSampler::sample(const std::vector<Vec3f>& field) {
  samples_ = sample_pages(small_pages().grid, evaluations_, field).value();
}

std::vector<WantedPage> PageSampler::wanted(const ShownPages& shown) const {
  std::vector<WantedPage> wanted;
  for (const ShownPage& page : shown.pages()) wanted.push_back({.steps = steps(page.page)});
  return wanted;
}

ShownPage plain_page(PageId page, uint32_t values) {
  Page bare;
  bare.positions.resize(values);
  return {page, std::make_shared<const PageLayout>(make_vertex_page_layout(bare))};
}

std::vector<int32_t> values_of(const PageFrameState& state) {
  std::vector<int32_t> all;
  for (const PageTile& tile : state.tiles) {
    const size_t begin = all.size();
    all.resize(begin + tile.value_count());
    tile.read(std::span(all).subspan(begin));
  }
  return all;
}

std::vector<int32_t> rounded(std::span<const int32_t> steps, int shift) {
  const double size = std::ldexp(1.0, shift);
  std::vector<int32_t> values;
  for (const int32_t step : steps)
    values.push_back(static_cast<int32_t>(std::floor(step / size + 0.5) * size));
  return values;
}

}  // namespace burnish
