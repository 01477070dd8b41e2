#include "server/fields/rims.h"

#include <algorithm>
#include <utility>

#include "common/base/disjoint_sets.h"
#include "common/grid/morton.h"
#include "common/grid/stencil_slots.h"
#include "server/fields/edge_census.h"
#include "server/fields/held_lines.h"

namespace burnish {
namespace {

/// Two pieces are beside each other within one to two of these lengths. Range scans of one object
/// lie as near as their noise, which is about an edge.
constexpr double kBesideEdges = 1.5;
constexpr double kBucketsPerSideMax = 1 << 17;  // the range of a Morton key, with a margin
/// So much of a rim must be free of other pieces, or none of it is held: the border of a range scan
/// that runs over others is no border of the object.
constexpr double kFreePartMin = 0.75;

/// The pieces of the surface, and where each has vertices.
class Pieces {
 public:
  Pieces(const PreparedMesh& prepared, const EdgeCensus& census)
      : vertices_(prepared.vertices),
        piece_(prepared.vertices.size(), kNone),
        origin_(prepared.statistics.box_min),
        width_(std::max(kBesideEdges * prepared.statistics.mean_edge_length,
                        prepared.statistics.diagonal() / kBucketsPerSideMax)) {
    if (find_pieces(prepared.triangles, census.place) > 1) fill_buckets();
  }

  int32_t of(uint32_t vertex) const { return piece_[vertex]; }

  /// Returns whether another piece is in the buckets around the middle of an edge.
  bool is_beside_another(const RimEdge& edge) const {
    if (buckets_.empty()) return false;
    const Vec3i place = bucket_of((vertices_[edge.from] + vertices_[edge.to]) / 2);
    for (int slot = 0; slot < kSlots; ++slot) {
      const Vec3i near = place + Vec3i(slot % 3 - 1, slot / 3 % 3 - 1, slot / 9 - 1);
      if (near.minCoeff() >= 0 && has_other(morton_key(near), of(edge.from))) return true;
    }
    return false;
  }

 private:
  struct Entry {
    MortonKey bucket;
    int32_t piece;
    auto operator<=>(const Entry&) const = default;
  };

  // A bucket has each of its pieces once.
  bool has_other(MortonKey bucket, int32_t piece) const {
    auto entry = std::ranges::lower_bound(buckets_, bucket, {}, &Entry::bucket);
    if (entry != buckets_.end() && entry->bucket == bucket && entry->piece == piece) ++entry;
    return entry != buckets_.end() && entry->bucket == bucket;
  }

  Vec3i bucket_of(const Vec3d& at) const {
    return ((at - origin_) / width_).array().floor().cast<int>();
  }

  /// Returns how many there are. Vertices without a triangle, and those that are not the least at
  /// their place, belong to none.
  size_t find_pieces(std::span<const Triangle> triangles, const ScratchArray<uint32_t>& place) {
    DisjointSets sets(place.size());
    for (const Triangle& t : triangles) {
      const auto first = static_cast<int32_t>(place[t[0]]);
      for (const uint32_t v : t) {
        sets.join(first, static_cast<int32_t>(place[v]));
        piece_[place[v]] = first;
      }
    }
    size_t count = 0;
    for (size_t v = 0; v < piece_.size(); ++v) {
      if (piece_[v] == kNone) continue;
      piece_[v] = sets.root(piece_[v]);
      count += piece_[v] == static_cast<int32_t>(v);
    }
    return count;
  }

  void fill_buckets() {
    for (size_t v = 0; v < piece_.size(); ++v)
      if (piece_[v] != kNone) buckets_.push_back({morton_key(bucket_of(vertices_[v])), piece_[v]});
    std::ranges::sort(buckets_);
    buckets_.erase(std::unique(buckets_.begin(), buckets_.end()), buckets_.end());
  }

  std::span<const Vec3d> vertices_;
  std::vector<int32_t> piece_;  // per vertex: the least vertex of its piece
  Vec3d origin_;
  double width_;                // of a bucket, file units
  std::vector<Entry> buckets_;  // sorted; none if there is one piece
};

/// Edges that meet.
struct Rim {
  int32_t piece = kNone;
  double length = 0, free_length = 0;  // file units; free of other pieces
  bool is_held = false;
};

/// The rims of a scan, and to which each of the census' edges belongs.
class Rims {
 public:
  Rims(const PreparedMesh& prepared, const EdgeCensus& census, const Pieces& pieces)
      : edges_(census.rims), rim_of_edge_(edges_.size()), is_free_(edges_.size()) {
    number_rims(prepared.vertices.size());
    for (size_t e = 0; e < edges_.size(); ++e) {
      const auto& [from, to] = edges_[e];
      const double length = (prepared.vertices[to] - prepared.vertices[from]).norm();
      is_free_[e] = !pieces.is_beside_another(edges_[e]);
      Rim& rim = rims_[rim_of_edge_[e]];
      rim.piece = pieces.of(from);
      rim.length += length;
      if (is_free_[e]) rim.free_length += length;
    }
    choose(kHeldRimEdgesMin * prepared.statistics.mean_edge_length, prepared.vertices.size());
  }

  size_t count() const { return rims_.size(); }
  size_t held_count() const { return std::ranges::count(rims_, true, &Rim::is_held); }

  template <typename Visit>
  void for_each_held_edge(const Visit& visit) const {
    for (size_t e = 0; e < edges_.size(); ++e)
      if (is_free_[e] && rims_[rim_of_edge_[e]].is_held) visit(edges_[e]);
  }

 private:
  void number_rims(size_t vertices) {
    DisjointSets sets(vertices);
    for (const auto& [from, to] : edges_)
      sets.join(static_cast<int32_t>(from), static_cast<int32_t>(to));
    std::vector<int32_t> rim_of_root(vertices, kNone);
    for (size_t e = 0; e < edges_.size(); ++e) {
      int32_t& rim = rim_of_root[sets.root(static_cast<int32_t>(edges_[e].from))];
      if (rim == kNone) {
        rim = static_cast<int32_t>(rims_.size());
        rims_.emplace_back();
      }
      rim_of_edge_[e] = rim;
    }
  }

  void choose(double length_min, size_t vertices) {
    std::vector<double> longest(vertices, 0);  // per piece
    for (const Rim& rim : rims_) longest[rim.piece] = std::max(longest[rim.piece], rim.length);
    for (Rim& rim : rims_)
      rim.is_held = rim.free_length >= kFreePartMin * rim.length &&
                    (rim.length >= length_min || rim.length == longest[rim.piece]);
  }

  std::span<const RimEdge> edges_;
  std::vector<int32_t> rim_of_edge_;
  std::vector<uint8_t> is_free_;  // per edge
  std::vector<Rim> rims_;
};

// Leaves out vertices that no triangle has: they do not move anyway.
void find_vertices(const std::vector<bool>& is_on_rim, const EdgeCensus& census,
                   const PreparedMesh& prepared, HeldRims& held) {
  std::vector<bool> has_one(is_on_rim.size(), false);  // by place
  for (size_t v = 0; v < is_on_rim.size(); ++v) {
    const uint32_t place = census.place[v];
    if (!is_on_rim[place] || prepared.evaluation[v].cell == kNone) continue;
    held.vertices.push_back(static_cast<uint32_t>(v));
    if (!has_one[place]) held.places.push_back(static_cast<uint32_t>(v));
    has_one[place] = true;
  }
}

}  // namespace

HeldRims find_held_rims(const PreparedMesh& prepared) {
  HeldRims held;
  if (prepared.statistics.is_closed()) return held;
  const EdgeCensus census = take_edge_census(prepared.vertices, prepared.triangles);
  const Rims rims(prepared, census, Pieces(prepared, census));
  HeldLines lines(prepared);
  std::vector<bool> is_on_rim(prepared.vertices.size(), false);
  const auto grid_point = [&](uint32_t v) {
    return snap_to_planes(prepared.frame.to_grid(prepared.vertices[v]));
  };
  rims.for_each_held_edge([&](const RimEdge& edge) {
    is_on_rim[edge.from] = is_on_rim[edge.to] = true;
    lines.add(grid_point(edge.from), grid_point(edge.to));
  });
  held.rims = rims.count();
  held.held = rims.held_count();
  held.lines = lines.take();
  held.first = first_lines(held.lines, prepared.cells.size());
  find_vertices(is_on_rim, census, prepared, held);
  return held;
}

std::string describe(const HeldRims& rims) {
  const auto rims_of = [](uint64_t n) { return std::to_string(n) + (n == 1 ? " rim" : " rims"); };
  if (rims.held == rims.rims)
    return (rims.held == 1 ? "the one rim stays where it is"
                           : "all " + rims_of(rims.held) + " stay where they are");
  if (rims.held == 0)
    return "none of " + rims_of(rims.rims) +
           " stays where it is: they are small holes, or run over another piece";
  return std::to_string(rims.held) + " of " + rims_of(rims.rims) +
         (rims.held == 1 ? " stays where it is" : " stay where they are") +
         "; the others are small holes, or run over another piece";
}

uint64_t held_rims_bytes(uint64_t vertices, uint64_t triangles, uint64_t cells, uint64_t rims) {
  constexpr uint64_t kEntry = 2 * sizeof(uint64_t);  // of a piece in a bucket
  constexpr uint64_t kGrowth = 2;                    // of a vector that grows by itself
  constexpr uint64_t kPerVertex = kGrowth * kEntry + 3 * sizeof(int32_t) + sizeof(double) + 1;
  constexpr uint64_t kAnchor = 1024;  // corners near a held edge, and their shares
  constexpr uint64_t kPerRim = 2 * (kGrowth + 1) * sizeof(LineMass) + sizeof(Rim) + 5 + kAnchor;
  return edge_census_bytes(vertices, triangles, rims) + vertices * kPerVertex + rims * kPerRim +
         cells / LineView::kStretch * sizeof(int32_t);
}

bool is_closed(const PreparedMesh& prepared) {
  return take_edge_census(prepared.vertices, prepared.triangles).is_closed;
}

}  // namespace burnish
