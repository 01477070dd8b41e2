#include "common/pages/page_walk.h"

#include <string>

#include "common/base/groups.h"
#include "common/pages/walk_edges.h"

namespace burnish {

namespace {

constexpr uint16_t kNotMet = 0xffff;

/// Plans the walk over a page.
class Planner {
 public:
  explicit Planner(const Page& page)
      : triangles_(page.triangles),
        edges_(page.positions.size(), triangles_.size()),
        numbers_(page.positions.size(), kNotMet),
        is_visited_(triangles_.size(), 0) {
    for (size_t p = 0; p < page.patches.size(); ++p)
      patches_.insert(patches_.end(), page.patches[p].triangles, static_cast<uint16_t>(p));
    sides_ = group_by<uint16_t>(page.positions.size(), [&](auto&& add) {
      for (size_t side = 0; side < 3 * triangles_.size(); ++side)
        add(triangles_[side / 3][side % 3], static_cast<uint16_t>(side));
    });
  }

  PlannedWalk plan() {
    for (size_t t = 0; t < triangles_.size(); ++t) {
      if (is_visited_[t] != 0) continue;
      start_at(t);
      while (visited_ < triangles_.size() && edges_.advance()) step();
    }
    return std::move(planned_);
  }

 private:
  void start_at(size_t t) {
    uint8_t named = 0;
    PageTriangle triangle;
    for (int k = 0; k < 3; ++k) {
      const uint16_t vertex = triangles_[t][k];
      if (numbers_[vertex] == kNotMet) {
        meet(vertex);
      } else {
        name(vertex);
        named |= static_cast<uint8_t>(1u << k);
      }
      triangle[k] = numbers_[vertex];
    }
    planned_.code.steps.push_back(kStepStart + named);
    visit(t, last_patch_);
    edges_.start(triangle, patches_[t]);
  }

  void step() {
    const WalkEdge edge = edges_.current();
    const int side = find(planned_.sources[edge.to], planned_.sources[edge.from]);
    if (side < 0) {
      planned_.code.steps.push_back(kStepNone);
      return edges_.close();
    }
    const size_t t = side / 3;
    const uint16_t vertex = triangles_[t][(side + 2) % 3];
    planned_.code.steps.push_back(step_to(vertex));
    visit(t, edge.patch);
    edges_.attach(numbers_[vertex], patches_[t]);
  }

  WalkStep step_to(uint16_t vertex) {
    const uint16_t number = numbers_[vertex];
    if (number == kNotMet) {
      meet(vertex);
      return kStepNew;
    }
    if (number == edges_.left_vertex()) return kStepLeft;
    if (number == edges_.right_vertex()) return kStepRight;
    name(vertex);
    return kStepNamed;
  }

  /// Returns a side of a triangle that is not visited, or -1.
  int find(uint16_t from, uint16_t to) const {
    for (const uint16_t side : sides_[from])
      if (is_visited_[side / 3] == 0 && triangles_[side / 3][(side + 1) % 3] == to) return side;
    return -1;
  }

  void meet(uint16_t vertex) {
    numbers_[vertex] = static_cast<uint16_t>(planned_.sources.size());
    planned_.sources.push_back(vertex);
  }
  void name(uint16_t vertex) {
    const size_t newest = planned_.sources.size() - 1;
    planned_.code.named_vertices.push_back(static_cast<uint16_t>(newest - numbers_[vertex]));
  }
  void visit(size_t t, uint16_t expected_patch) {
    is_visited_[t] = 1;
    ++visited_;
    last_patch_ = patches_[t];
    planned_.code.turns.push_back(last_patch_ != expected_patch ? 1 : 0);
    if (last_patch_ != expected_patch) planned_.code.named_patches.push_back(last_patch_);
  }

  std::span<const PageTriangle> triangles_;
  WalkEdges edges_;
  std::vector<uint16_t> numbers_;    // per vertex of the page, its place in the walk
  std::vector<uint8_t> is_visited_;  // per triangle
  std::vector<uint16_t> patches_;    // per triangle
  Groups<uint16_t> sides_;           // by the vertex where they begin
  size_t visited_ = 0;
  uint16_t last_patch_ = 0;
  PlannedWalk planned_;
};

/// Follows the code of a walk.
class Follower {
 public:
  Follower(const WalkCode& code, size_t vertices, size_t patches)
      : code_(code), vertices_(vertices), patches_(patches), edges_(vertices, code.turns.size()) {
    walk_.triangles.reserve(code.turns.size());
    walk_.patches.reserve(code.turns.size());
    walk_.origins.reserve(vertices);
  }

  Result<PageWalk> follow() {
    for (const uint8_t step : code_.steps) {
      const bool is_at_edge = edges_.advance();
      const bool is_right = is_at_edge ? take_step(step) : take_start(step);
      if (!is_right)
        return data_loss("step " + std::to_string(steps_) + " of the walk, " +
                         std::to_string(step) + ", cannot be taken");
      ++steps_;
    }
    RETURN_IF_ERROR(check_end());
    return std::move(walk_);
  }

 private:
  bool take_start(uint8_t step) {
    if (step < kStepStart || step >= kStepStart + 8) return false;
    PageTriangle triangle;
    for (int k = 0; k < 3; ++k) {
      const auto before = static_cast<uint16_t>(walk_.origins.empty() ? 0 : newest());
      const bool is_right = (step >> k & 1) != 0 ? take_named(triangle[k])
                                                 : take_new({before, before, before}, triangle[k]);
      if (!is_right) return false;
    }
    if (!add(triangle, last_patch_)) return false;
    edges_.start(triangle, last_patch_);
    return true;
  }

  bool take_step(uint8_t step) {
    const WalkEdge edge = edges_.current();
    uint16_t w = 0;
    switch (step) {
      case kStepNone:
        edges_.close();
        return true;
      case kStepNew:
        if (!take_new({edge.from, edge.to, edge.apex}, w)) return false;
        break;
      case kStepLeft:
        w = edges_.left_vertex();
        break;
      case kStepRight:
        w = edges_.right_vertex();
        break;
      case kStepNamed:
        if (!take_named(w)) return false;
        break;
      default:
        return false;
    }
    if (!add({edge.to, edge.from, w}, edge.patch)) return false;
    edges_.attach(w, last_patch_);
    return true;
  }

  size_t newest() const { return walk_.origins.size() - 1; }

  bool take_new(const WalkOrigin& origin, uint16_t& w) {
    if (walk_.origins.size() == vertices_) return false;
    walk_.origins.push_back(origin);
    w = static_cast<uint16_t>(newest());
    return true;
  }
  bool take_named(uint16_t& w) {
    if (named_vertices_ == code_.named_vertices.size()) return false;
    const size_t back = code_.named_vertices[named_vertices_++];
    if (back >= walk_.origins.size()) return false;
    w = static_cast<uint16_t>(newest() - back);
    return true;
  }
  bool add(const PageTriangle& triangle, uint16_t patch) {
    if (walk_.triangles.size() == code_.turns.size()) return false;
    if (code_.turns[walk_.triangles.size()] != 0) {
      if (named_patches_ == code_.named_patches.size()) return false;
      patch = code_.named_patches[named_patches_++];
    }
    if (patch >= patches_) return false;
    walk_.triangles.push_back(triangle);
    walk_.patches.push_back(patch);
    last_patch_ = patch;
    return true;
  }

  Status check_end() const {
    const auto check = [](const char* name, size_t met, size_t given) {
      if (met == given) return Status::ok();
      return data_loss("the walk meets " + std::to_string(met) + " of " + std::to_string(given) +
                       " " + name);
    };
    RETURN_IF_ERROR(check("vertices", walk_.origins.size(), vertices_));
    RETURN_IF_ERROR(check("triangles", walk_.triangles.size(), code_.turns.size()));
    RETURN_IF_ERROR(check("named vertices", named_vertices_, code_.named_vertices.size()));
    return check("named patches", named_patches_, code_.named_patches.size());
  }

  const WalkCode& code_;
  const size_t vertices_;
  const size_t patches_;
  WalkEdges edges_;
  PageWalk walk_;
  size_t steps_ = 0;
  size_t named_vertices_ = 0;
  size_t named_patches_ = 0;
  uint16_t last_patch_ = 0;
};

}  // namespace

PlannedWalk plan_walk(const Page& page) {
  return Planner(page).plan();
}

Result<PageWalk> follow_walk(const WalkCode& code, size_t vertices, size_t patches) {
  return Follower(code, vertices, patches).follow();
}

}  // namespace burnish
