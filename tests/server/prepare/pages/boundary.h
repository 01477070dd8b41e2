#pragma once

#include <array>
#include <cstdint>
#include <unordered_map>

namespace burnish {

/// The boundary of a surface, as algebra has it: per edge how often triangles pass it one way minus
/// the other way, and whether an odd number has it. Edges that have neither are not on the
/// boundary. The boundary of several surfaces together is the sum of their boundaries.
///
/// It tells cracks exactly, for non-manifold soup too: moving vertices together, as simplification
/// does, moves a boundary but never opens one.
class Boundary {
 public:
  struct Passes {
    int32_t sum = 0;
    bool is_odd = false;

    bool is_none() const { return sum == 0 && !is_odd; }
    bool operator==(const Passes&) const = default;
  };
  using Edge = uint64_t;  ///< two numbers of places, the lesser one above

  void add_triangle(const std::array<uint32_t, 3>& places);
  void add(const Boundary& other);

  /// None for an edge that is not on the boundary.
  Passes at(Edge edge) const;
  const std::unordered_map<Edge, Passes>& edges() const { return edges_; }

 private:
  void add(Edge edge, const Passes& passes);

  std::unordered_map<Edge, Passes> edges_;
};

}  // namespace burnish
