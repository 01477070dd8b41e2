#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "client/cli/bench/load_mix.h"
#include "client/cli/bench/load_surface.h"
#include "client/connection/session_link.h"

namespace burnish {

/// Makes drags and strokes, one gesture after the other. Each picture previews the gesture; its end
/// applies it. The same seed gives the same gestures.
class Gestures {
 public:
  using Time = std::chrono::steady_clock::time_point;

  /// Strokes go along the points of the surface. Needs: at least one.
  Gestures(std::shared_ptr<const LoadSurface> surface, const LoadMix& mix, uint32_t seed);

  /// Continues the gesture, or begins the next.
  void advance(Time now, SessionLink& session);
  /// Ends the gesture and applies its edit.
  void end(SessionLink& session);

  const std::vector<std::string>& applied() const { return applied_; }  ///< ids of edits

 private:
  void begin(Time now);
  void advance_stroke(SessionLink& session);
  std::optional<Vec3d> next_point();
  void apply(SessionLink& session, Edit edit);

  const std::shared_ptr<const LoadSurface> surface_;
  const LoadMix mix_;
  std::mt19937 random_;
  const double radius_;

  Activity activity_ = Activity::kDraw;
  Time end_ = {};
  std::string edit_id_;
  double beta_ = 1;
  double beta_step_ = 0;
  Stroke stroke_;
  size_t point_ = 0;  // of the surface, the stroke's last
  std::vector<std::string> applied_;
};

}  // namespace burnish
