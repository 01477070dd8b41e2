#include <string>

#include "common/pages/page_walk.h"
#include "common/pages/walk_edges.h"

namespace burnish {

namespace {

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

Result<PageWalk> follow_walk(const WalkCode& code, size_t vertices, size_t patches) {
  return Follower(code, vertices, patches).follow();
}

}  // namespace burnish
