#include "tests/common/pages/made_pages.h"

#include <algorithm>
#include <cmath>

namespace burnish {

namespace {

using Random = std::mt19937;

int below(Random& random, int end) {
  return static_cast<int>(random() % static_cast<uint32_t>(end));
}

Vec3f random_normal(Random& random) {
  Vec3f direction;
  do {
    for (float& part : direction) part = static_cast<float>(below(random, 2001) - 1000);
  } while (direction.norm() < 1);
  return direction.normalized();
}

void add_attributes(const PageWishes& wishes, Random& random, Page& page) {
  const size_t vertices = page.positions.size();
  page.border_vertices = static_cast<uint32_t>(vertices / 3);
  const size_t normals = wishes.has_all_normals ? vertices : page.border_vertices;
  for (size_t v = 0; v < normals; ++v) page.normals.push_back(random_normal(random));
  if (!wishes.has_colours) return;
  for (size_t v = 0; v < vertices; ++v) {
    Rgba8 colour;
    for (uint8_t& channel : colour) channel = static_cast<uint8_t>(random());
    page.colours.push_back(colour);
  }
}

void add_patches(int patches, Random& random, Page& page) {
  const auto triangles = static_cast<uint32_t>(page.triangles.size());
  if (patches == 0) {
    page.patches = {{kNoPage, triangles}};
    return;
  }
  uint32_t left = triangles;
  PageId finer = 0;
  for (int p = 0; p + 1 < patches; ++p) {
    finer += 1 + static_cast<PageId>(below(random, 3));
    const uint32_t count = left / static_cast<uint32_t>(patches - p);
    page.patches.push_back({finer, count});
    left -= count;
  }
  page.patches.push_back({finer + 1, left});
}

}  // namespace

PageMeaning meaning_of(const Page& page) {
  PageMeaning meaning;
  for (size_t v = 0; v < page.positions.size(); ++v) {
    const Vec3i& p = page.positions[v];
    PageMeaning::Vertex vertex = {p.x(), p.y(), p.z(), v < page.border_vertices ? 1 : 0};
    if (!page.colours.empty()) std::ranges::copy(page.colours[v], vertex.begin() + 4);
    meaning.vertices.push_back(vertex);
  }
  size_t t = 0;
  for (const PagePatch& patch : page.patches)
    for (uint32_t i = 0; i < patch.triangles; ++i, ++t) {
      const PageTriangle& triangle = page.triangles[t];
      std::array<std::array<PageMeaning::Vertex, 3>, 3> turned;
      for (int turn = 0; turn < 3; ++turn)
        for (int k = 0; k < 3; ++k) turned[turn][k] = meaning.vertices[triangle[(k + turn) % 3]];
      meaning.triangles.emplace_back(patch.finer, std::ranges::min(turned));
    }
  std::ranges::sort(meaning.triangles);
  std::ranges::sort(meaning.vertices);
  return meaning;
}

Page two_triangles() {
  return {.id = 0,
          .patches = {{kNoPage, 2}},
          .triangles = {{0, 1, 2}, {2, 1, 3}},
          .positions = {{0, 0, 0}, {100, 0, 5}, {0, 120, 7}, {(1 << 24) - 1, 110, 9}},
          .border_vertices = 2,
          .normals = {Vec3f(0, 0, 1), Vec3f(0, -1, 0)}};
}

Page made_sheet(const PageWishes& wishes, uint32_t seed) {
  Random random(seed);
  Page page{.id = wishes.id};
  const int columns = wishes.columns;
  const int rows = wishes.rows;
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < columns; ++x)
      page.positions.emplace_back(5000 + 256 * x + below(random, 60),
                                  9000 + 256 * y + below(random, 60), 400 + below(random, 60));
  const int last = wishes.is_closed ? 0 : 1;
  const auto at = [&](int x, int y) {
    return static_cast<uint16_t>(x % columns + y % rows * columns);
  };
  for (int y = 0; y < rows - last; ++y)
    for (int x = 0; x < columns - last; ++x) {
      page.triangles.push_back({at(x, y), at(x + 1, y), at(x, y + 1)});
      page.triangles.push_back({at(x, y + 1), at(x + 1, y), at(x + 1, y + 1)});
    }
  add_patches(wishes.patches, random, page);
  add_attributes(wishes, random, page);
  return page;
}

Page made_soup(size_t vertices, size_t triangles, uint32_t seed) {
  Random random(seed);
  Page page{.id = 100};
  for (size_t v = 0; v < vertices; ++v)
    page.positions.emplace_back(below(random, 1 << 24), below(random, 1 << 24),
                                below(random, 1 << 24));
  for (size_t t = 0; t < triangles; ++t) {
    PageTriangle triangle;
    for (uint16_t& vertex : triangle)
      vertex = static_cast<uint16_t>(below(random, static_cast<int>(vertices)));
    if (t < vertices) triangle[0] = static_cast<uint16_t>(t);  // each vertex has a triangle
    page.triangles.push_back(triangle);
  }
  add_patches(4, random, page);
  add_attributes({}, random, page);
  return page;
}

}  // namespace burnish
