#pragma once

#include <array>
#include <deque>

#include <Eigen/Core>

namespace burnish {

inline constexpr int kPointerButtons = 3;

/// The pointer as the panels see it. Panels look at the pointer once per picture. They would miss a
/// click between two pictures, and the begin and end of a drag. So the queue shows the pointer in
/// steps, with one change of a button per picture.
class PointerQueue {
 public:
  struct State {
    Eigen::Vector2d place = Eigen::Vector2d::Zero();
    std::array<bool, kPointerButtons> down{};
  };

  void move(const Eigen::Vector2d& place);
  /// Adds a change of a button at the pointer's place. Needs: 0 <= button < kPointerButtons.
  void press(int button, bool down);

  /// Returns the next step: all moves up to a change of a button, or that change.
  const State& next();
  /// Returns true if there are more steps.
  bool has_more() const { return !steps_.empty(); }

  /// Returns the last place of the pointer.
  const Eigen::Vector2d& place() const { return last_; }

 private:
  struct Step {
    Eigen::Vector2d place;
    int button = -1;  // -1: a move
    bool down = false;
  };

  std::deque<Step> steps_;
  Eigen::Vector2d last_ = Eigen::Vector2d::Zero();
  State shown_;
};

}  // namespace burnish
