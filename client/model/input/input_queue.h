#pragma once

#include <array>
#include <deque>
#include <optional>
#include <vector>

#include <Eigen/Core>

namespace burnish {

inline constexpr int kPointerButtons = 3;

/// An event of the pointer or the keyboard. Codes and modifiers are the window system's.
struct InputEvent {
  enum class Kind {
    kMove,
    kLeave,  ///< the pointer is outside the window
    kButton,
    kWheel,
    kKey,
    kCharacter,
  };
  Kind kind = Kind::kMove;
  Eigen::Vector2d place = Eigen::Vector2d::Zero();  ///< of the pointer
  int code = 0;                                     ///< button, key or character
  bool down = false;
  int modifiers = 0;
  int scancode = 0;
  double steps = 0;                ///< of the wheel
  std::optional<double> pressure;  ///< of a pen that draws, 0 to 1
};

/// Hands events to the panels and to the picture in the order in which they came. Panels look at
/// the pointer once per picture: a second change of a button or of a key in one picture hides the
/// first. So the queue gives events in steps, one step per picture. A field that a click opens
/// takes keys some pictures later. So what is typed after a click waits for these.
class InputQueue {
 public:
  struct Pointer {
    Eigen::Vector2d place = Eigen::Vector2d::Zero();
    std::array<bool, kPointerButtons> down{};
  };

  /// Adds an event at the pointer's last place; a move or leave has its own place.
  /// Needs: 0 <= code < kPointerButtons for a button.
  void add(InputEvent event);

  static constexpr int kPicturesUntilTyping = 3;  ///< after a change of a button

  /// Returns the next step: moves, turns of the wheel, or one change of a button; or keys and
  /// characters, with one change of each key. Empty if nothing is left, or what is typed must wait.
  std::vector<InputEvent> next();
  /// Returns true if there are more steps.
  bool has_more() const { return !events_.empty(); }

  /// Returns the pointer after the last step, as the panels see it.
  const Pointer& pointer() const { return pointer_; }

 private:
  static bool belongs_to(const std::vector<InputEvent>& step, const InputEvent& event);

  std::deque<InputEvent> events_;
  Eigen::Vector2d last_ = Eigen::Vector2d::Zero();
  Pointer pointer_;
  int pictures_until_typing_ = 0;
};

}  // namespace burnish
