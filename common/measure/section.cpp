#include "common/measure/section.h"

#include <algorithm>
#include <array>
#include <unordered_map>

namespace burnish {

namespace {

/// The edge of two vertices, the lesser index first.
uint64_t edge_key(uint32_t a, uint32_t b) {
  return (uint64_t{std::min(a, b)} << 32) | std::max(a, b);
}

/// A triangle's part of the section: it leads from one edge to another.
struct Piece {
  std::array<uint64_t, 2> edges;
};

std::vector<Piece> pieces_of(std::span<const double> heights, std::span<const Triangle> triangles) {
  std::vector<Piece> pieces;
  for (const Triangle& t : triangles) {
    Piece piece = {};
    int crossed = 0;
    for (int c = 0; c < 3 && crossed < 2; ++c) {
      const uint32_t from = t[c], to = t[(c + 1) % 3];
      if ((heights[from] >= 0) != (heights[to] >= 0)) piece.edges[crossed++] = edge_key(from, to);
    }
    if (crossed == 2 && piece.edges[0] != piece.edges[1]) pieces.push_back(piece);
  }
  return pieces;
}

/// Joins pieces at their common edges to lines.
class Joiner {
 public:
  explicit Joiner(std::span<const Piece> pieces) : pieces_(pieces), is_taken_(pieces.size()) {
    for (size_t p = 0; p < pieces.size(); ++p)
      for (const uint64_t edge : pieces[p].edges) at_edge_[edge].push_back(p);
  }

  /// Returns the edges of each line in their order.
  std::vector<std::vector<uint64_t>> join() {
    std::vector<std::vector<uint64_t>> lines;
    for (size_t p = 0; p < pieces_.size(); ++p)  // lines that have ends
      for (const uint64_t end : pieces_[p].edges)
        if (at_edge_.at(end).size() != 2 && !is_taken_[p]) lines.push_back(follow(p, end));
    for (size_t p = 0; p < pieces_.size(); ++p)  // the others are closed
      if (!is_taken_[p]) lines.push_back(follow(p, pieces_[p].edges[0]));
    return lines;
  }

 private:
  /// Follows the line that enters a piece by an edge until it ends or meets itself.
  std::vector<uint64_t> follow(size_t piece, uint64_t edge) {
    std::vector<uint64_t> line = {edge};
    for (;;) {
      is_taken_[piece] = true;
      const Piece& at = pieces_[piece];
      edge = at.edges[0] == edge ? at.edges[1] : at.edges[0];
      line.push_back(edge);
      const std::vector<size_t>& here = at_edge_.at(edge);
      if (here.size() != 2) return line;
      piece = here[0] == piece ? here[1] : here[0];
      if (is_taken_[piece]) return line;
    }
  }

  std::span<const Piece> pieces_;
  std::vector<bool> is_taken_;
  std::unordered_map<uint64_t, std::vector<size_t>> at_edge_;
};

/// Points at which the plane crosses edges, in the plane's axes.
class Crossings {
 public:
  Crossings(std::span<const Vec3d> vertices, std::span<const double> heights, const Plane& plane)
      : vertices_(vertices), heights_(heights), plane_(plane), axes_(axes_of(plane)) {}

  Eigen::Vector2d at(uint64_t edge) const {
    const auto from = static_cast<uint32_t>(edge >> 32), to = static_cast<uint32_t>(edge);
    const double part = heights_[from] / (heights_[from] - heights_[to]);
    const Vec3d point = vertices_[from] + part * (vertices_[to] - vertices_[from]) - plane_.point;
    return {axes_.right.dot(point), axes_.up.dot(point)};
  }

 private:
  std::span<const Vec3d> vertices_;
  std::span<const double> heights_;
  const Plane& plane_;
  const PlaneAxes axes_;
};

}  // namespace

Result<std::vector<SectionLine>> cut_surface(std::span<const Vec3d> vertices,
                                             std::span<const Triangle> triangles,
                                             const Plane& plane) {
  std::vector<double> heights(vertices.size());
  for (size_t v = 0; v < vertices.size(); ++v) heights[v] = plane.height_of(vertices[v]);
  const std::vector<Piece> pieces = pieces_of(heights, triangles);
  if (pieces.size() > kSectionPointsMax)
    return resource_exhausted("the section has " + std::to_string(pieces.size()) +
                              " pieces, the limit is " + std::to_string(kSectionPointsMax));
  const Crossings crossings(vertices, heights, plane);
  std::vector<SectionLine> lines;
  for (const std::vector<uint64_t>& edges : Joiner(pieces).join()) {
    SectionLine& line = lines.emplace_back();
    for (const uint64_t edge : edges) line.points.push_back(crossings.at(edge));
  }
  return lines;
}

}  // namespace burnish
