#pragma once

#include <array>
#include <deque>

#include <Eigen/Core>

namespace burnish {

inline constexpr int kPointerButtons = 3;

/// The pointer as the panels are to see it. They look at it once per picture: of a click that came
/// and went between two pictures they would see nothing, and of a drag neither where it began nor
/// where it ended. So it is led past them in steps, with one change of a button in a picture.
class PointerQueue {
 public:
  struct State {
    Eigen::Vector2d place = Eigen::Vector2d::Zero();
    std::array<bool, kPointerButtons> down{};
  };

  void move(const Eigen::Vector2d& place);
  /// Where the pointer is. Needs: 0 <= button < kPointerButtons.
  void press(int button, bool down);

  /// The next step: as far as the pointer went until a button changed, or that change.
  const State& next();
  /// There are more steps.
  bool has_more() const { return !steps_.empty(); }

  /// Where the pointer went last.
  const Eigen::Vector2d& place() const { return last_; }

 private:
  struct Step {
    Eigen::Vector2d place;
    int button = -1;  // none: a move
    bool down = false;
  };

  std::deque<Step> steps_;
  Eigen::Vector2d last_ = Eigen::Vector2d::Zero();
  State shown_;
};

}  // namespace burnish
