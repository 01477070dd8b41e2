#pragma once

#include <cstdint>
#include <vector>

#include "common/pages/page.h"

namespace burnish {

enum WalkStep : uint8_t {
  kStepNew = 0,
  kStepLeft = 1,
  kStepRight = 2,
  kStepNone = 3,
  kStepNamed = 4,
  kStepStart = 8,
};

/// A side of a visited triangle.
struct WalkEdge {
  uint16_t from;
  uint16_t to;
  uint16_t apex;
  uint16_t patch;
  uint16_t before = 0;
  uint16_t after = 0;
  bool is_open = true;
};

/// The edges of a walk (page_walk.h), in the order in which they come. Both who plans a walk and
/// who follows it keep one. Any numbers are safe: links lead to edges of the list.
class WalkEdges {
 public:
  WalkEdges(size_t vertices, size_t triangles) : newest_at_(vertices, kNoEdge) {
    edges_.reserve(3 * triangles);
  }

  /// Moves to the next open edge. Returns false if there is none.
  bool advance() {
    while (current_ < edges_.size() && !edges_[current_].is_open) ++current_;
    return current_ < edges_.size();
  }
  const WalkEdge& current() const { return edges_[current_]; }
  uint16_t left_vertex() const { return edges_[current().before].from; }
  uint16_t right_vertex() const { return edges_[current().after].to; }

  void close() { edges_[current_].is_open = false; }

  void start(const PageTriangle& triangle, uint16_t patch) {
    const size_t first = edges_.size();
    for (size_t k = 0; k < 3; ++k)
      append({triangle[k], triangle[(k + 1) % 3], triangle[(k + 2) % 3], patch});
    for (size_t k = 0; k < 3; ++k) join(first + k, first + (k + 1) % 3);
  }

  /// Attaches a triangle at the current edge.
  void attach(uint16_t w, uint16_t patch) {
    const WalkEdge edge = current();
    const bool closes_before = left_vertex() == w;
    const bool closes_after = right_vertex() == w;
    const size_t cut = newest_at_[w];
    close();
    size_t left = edge.before;
    size_t right = edge.after;
    if (closes_before) {
      edges_[left].is_open = false;
      left = edges_[left].before;
    } else {
      const size_t added = append({edge.from, w, edge.to, patch});
      join(left, added);
      left = added;
    }
    if (closes_after) {
      edges_[right].is_open = false;
      right = edges_[right].after;
    } else {
      const size_t added = append({w, edge.to, edge.from, patch});
      join(added, right);
      right = added;
    }
    const bool is_cut = !closes_before && !closes_after && cut != kNoEdge && edges_[cut].is_open;
    if (is_cut) {
      join(edges_[cut].before, right);
      right = cut;
    }
    join(left, right);
  }

 private:
  static constexpr uint16_t kNoEdge = 0xffff;

  size_t append(const WalkEdge& edge) {
    newest_at_[edge.from] = static_cast<uint16_t>(edges_.size());
    edges_.push_back(edge);
    return edges_.size() - 1;
  }
  void join(size_t before, size_t after) {
    edges_[before].after = static_cast<uint16_t>(after);
    edges_[after].before = static_cast<uint16_t>(before);
  }

  std::vector<WalkEdge> edges_;
  std::vector<uint16_t> newest_at_;  // per vertex, the newest edge that begins there
  size_t current_ = 0;
};

}  // namespace burnish
