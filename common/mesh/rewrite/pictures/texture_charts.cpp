#include "common/mesh/rewrite/pictures/texture_charts.h"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

#include "common/base/disjoint_sets.h"
#include "common/mesh/reading/vertex_welder.h"
#include "common/mesh/textures/shown_picture.h"

namespace burnish {

namespace {

/// An edge of a triangle at which a seam may lie.
struct HalfEdge {
  uint32_t low, high;  // places of its ends
  uint32_t triangle;
  uint8_t at_low, at_high;  // corners
};

class ChartFinder {
 public:
  ChartFinder(const TexturedSurface& surface, const FileBudget& budget)
      : surface_(surface), budget_(budget), chart_(surface.mesh.triangles.size()) {}

  Result<TextureCharts> find() {
    RETURN_IF_ERROR(weld());
    RETURN_IF_ERROR(sort_corners());
    RETURN_IF_ERROR(join_triangles());
    RETURN_IF_ERROR(number_points());
    RETURN_IF_ERROR(find_seams());
    return std::move(charts_);
  }

  /// Returns the memory that it takes: places, corners by place, points, charts.
  static uint64_t bytes_of(const TexturedSurface& surface) {
    constexpr uint64_t kPerVertex = sizeof(Vec3d) * 2 + 6 * sizeof(uint32_t);
    constexpr uint64_t kPerTriangle = 12 * sizeof(uint32_t);
    return kPerVertex * surface.mesh.vertices.size() + kPerTriangle * surface.mesh.triangles.size();
  }

 private:
  static constexpr size_t kHeard = size_t{1} << 16;

  Status hear_at(size_t step) const { return step % kHeard == 0 ? hear(budget_) : Status::ok(); }
  size_t place_count() const { return place_begins_.size() - 1; }
  uint32_t place_of(uint32_t corner) const {
    return places_[surface_.mesh.triangles[corner / 3][corner % 3]];
  }
  /// Returns what corners of one place and one chart agree in.
  std::tuple<uint32_t, float, float> key_of(uint32_t corner) const {
    const SurfaceTextures& textures = surface_.textures;
    const TexturedTriangle& textured = textures.triangles[corner / 3];
    const auto& [u, v] = textures.coordinates[textured.corners[corner % 3]];
    return {textures.materials[textured.material].picture, u, v};
  }

  Status weld() {
    std::vector<Vec3d> distinct;
    VertexWelder welder(distinct);
    places_.reserve(surface_.mesh.vertices.size());
    for (size_t v = 0; v < surface_.mesh.vertices.size(); ++v) {
      RETURN_IF_ERROR(hear_at(v));
      places_.push_back(welder.index_of(surface_.mesh.vertices[v]));
    }
    place_begins_.assign(distinct.size() + 1, 0);
    return Status::ok();
  }

  /// Lists the corners of triangles with pictures by their places.
  Status sort_corners() {
    const size_t triangles = surface_.mesh.triangles.size();
    is_shown_.assign(triangles, 0);
    for (uint32_t t = 0; t < triangles; ++t) {
      RETURN_IF_ERROR(hear_at(t));
      is_shown_[t] = shown_picture(surface_.textures, t) != kNoTexture;
      for (uint32_t k = 0; is_shown_[t] && k < 3; ++k) ++place_begins_[place_of(3 * t + k) + 1];
    }
    std::partial_sum(place_begins_.begin(), place_begins_.end(), place_begins_.begin());
    charts_.corners.resize(place_begins_.back());
    std::vector<uint32_t> next(place_begins_.begin(), place_begins_.end() - 1);
    for (uint32_t t = 0; t < triangles; ++t) {
      RETURN_IF_ERROR(hear_at(t));
      for (uint32_t k = 0; is_shown_[t] && k < 3; ++k)
        charts_.corners[next[place_of(3 * t + k)]++] = 3 * t + k;
    }
    return Status::ok();
  }

  std::span<uint32_t> corners_at(size_t place) {
    return std::span(charts_.corners)
        .subspan(place_begins_[place], place_begins_[place + 1] - place_begins_[place]);
  }

  Status join_triangles() {
    for (size_t place = 0; place < place_count(); ++place) {
      RETURN_IF_ERROR(hear_at(place));
      const std::span<uint32_t> corners = corners_at(place);
      std::ranges::stable_sort(corners, {}, [&](uint32_t corner) { return key_of(corner); });
      for (size_t i = 1; i < corners.size(); ++i)
        if (key_of(corners[i - 1]) == key_of(corners[i]))
          chart_.join(static_cast<int32_t>(corners[i - 1] / 3),
                      static_cast<int32_t>(corners[i] / 3));
    }
    return Status::ok();
  }

  int32_t chart_of(uint32_t triangle) { return chart_.root(static_cast<int32_t>(triangle)); }

  Status number_points() {
    charts_.points.assign(3 * surface_.mesh.triangles.size(), kNoTexture);
    charts_.begins = {};
    is_shared_.assign(place_count(), 0);
    for (size_t place = 0; place < place_count(); ++place) {
      RETURN_IF_ERROR(hear_at(place));
      const std::span<uint32_t> corners = corners_at(place);
      std::ranges::sort(corners, {},
                        [&](uint32_t corner) { return std::pair(chart_of(corner / 3), corner); });
      for (size_t i = 0; i < corners.size(); ++i) {
        const bool is_other = i > 0 && chart_of(corners[i] / 3) != chart_of(corners[i - 1] / 3);
        if (i == 0 || is_other)
          charts_.begins.push_back(place_begins_[place] + static_cast<uint32_t>(i));
        if (is_other) is_shared_[place] = 1;
        charts_.points[corners[i]] = static_cast<uint32_t>(charts_.begins.size()) - 1;
      }
    }
    charts_.begins.push_back(static_cast<uint32_t>(charts_.corners.size()));
    for (uint32_t t = 0; t < is_shown_.size(); ++t)
      charts_.charts += is_shown_[t] && chart_of(t) == static_cast<int32_t>(t) ? 1 : 0;
    return Status::ok();
  }

  /// Returns the edges between places where charts meet, sorted by their ends.
  Result<std::vector<HalfEdge>> half_edges() const {
    std::vector<HalfEdge> edges;
    for (uint32_t t = 0; t < is_shown_.size(); ++t) {
      RETURN_IF_ERROR(hear_at(t));
      for (uint8_t k = 0; is_shown_[t] && k < 3; ++k) {
        const auto after = static_cast<uint8_t>((k + 1) % 3);
        const uint32_t a = place_of(3 * t + k), b = place_of(3 * t + after);
        if (a == b || !is_shared_[a] || !is_shared_[b]) continue;
        edges.push_back(a < b ? HalfEdge{a, b, t, k, after} : HalfEdge{b, a, t, after, k});
      }
    }
    RETURN_IF_ERROR(hear(budget_));
    std::ranges::sort(edges, {}, [](const HalfEdge& edge) {
      return std::tuple(edge.low, edge.high, edge.triangle);
    });
    return edges;
  }

  Status find_seams() {
    ASSIGN_OR_RETURN(const std::vector<HalfEdge> edges, half_edges());
    for (size_t begin = 0; begin < edges.size();) {
      size_t end = begin + 1;
      while (end < edges.size() && edges[end].low == edges[begin].low &&
             edges[end].high == edges[begin].high)
        ++end;
      if (end == begin + 2) add_seam(edges[begin], edges[begin + 1]);
      begin = end;
    }
    return hear(budget_);
  }

  void add_seam(const HalfEdge& one, const HalfEdge& other) {
    if (chart_of(one.triangle) == chart_of(other.triangle)) return;
    const auto side = [](const HalfEdge& edge) {
      return SeamEdge::Side{edge.triangle, {edge.at_low, edge.at_high}};
    };
    charts_.seams.push_back({{side(one), side(other)}});
  }

  const TexturedSurface& surface_;
  const FileBudget& budget_;
  TextureCharts charts_;
  DisjointSets chart_;            // of triangles
  std::vector<uint32_t> places_;  // of vertices: those at one position have one
  std::vector<uint32_t> place_begins_;
  std::vector<uint8_t> is_shown_;   // per triangle: it has a picture
  std::vector<uint8_t> is_shared_;  // per place: several charts meet there
};

}  // namespace

Result<TextureCharts> find_texture_charts(const TexturedSurface& surface,
                                          const FileBudget& budget) {
  if (budget) RETURN_IF_ERROR(budget(ChartFinder::bytes_of(surface)));
  return ChartFinder(surface, budget).find();
}

}  // namespace burnish
