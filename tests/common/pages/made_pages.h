#pragma once

#include <array>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

#include "common/pages/page.h"

namespace burnish {

/// What a page says, without the order of its vertices and triangles.
struct PageMeaning {
  using Vertex = std::array<int, 8>;  ///< position, on the border, colour
  std::vector<std::pair<PageId, std::array<Vertex, 3>>> triangles;
  std::vector<Vertex> vertices;
  bool operator==(const PageMeaning&) const = default;
};
PageMeaning meaning_of(const Page& page);

/// Returns two triangles of level 0 that share a side. Two of the vertices are on the border.
Page two_triangles();

/// What a made page has.
struct PageWishes {
  PageId id = 100;
  int columns = 8;
  int rows = 8;
  bool is_closed = false;  ///< a torus: 2 * columns * rows triangles
  int patches = 3;         ///< 0: a page of level 0
  bool has_all_normals = true;
  bool has_colours = true;
};

/// Returns a rough sheet of squares cut in two. Its patches, border, normals and colours are
/// random.
Page made_sheet(const PageWishes& wishes, uint32_t seed);

/// Returns triangles between random vertices: sides with many triangles, repeated triangles and
/// repeated vertices.
Page made_soup(size_t vertices, size_t triangles, uint32_t seed);

}  // namespace burnish
