#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "common/base/status.h"

namespace burnish {

/// Actions of keys.
enum class Action {
  kOpen,
  kUndo,
  kRedo,
  kFrameAll,
  kFocus,
  kBrushRadius,
  kBrushStrength,
  kRadiusDown,
  kRadiusUp,
  kNavigateMode,
  kMeasureMode,
  kWireframe,
  kSplit,
  kExport,
  kScreenshot,
  kBookmark,
  kFront,
  kBack,
  kRight,
  kLeft,
  kTop,
  kBottom,
  kOrthographic,
  kTurnLeft,
  kTurnRight,
  kTurnUp,
  kTurnDown,
  kLog,
  kHelp,
  kSave,
  kQuit,
  kCancel,
};

inline constexpr size_t kActions = 32;

struct ActionInfo {
  Action action;
  std::string_view name;  ///< in the configuration file
  std::string_view key;   ///< default key, e.g. "Ctrl+Z"
  std::string_view description;
  std::string_view also = {};  ///< a second default key, unless another action has it
};

/// Returns all actions, in the order of the key help.
const std::array<ActionInfo, kActions>& actions();

/// Maps keys to actions. A key is written as modifiers (Ctrl, Shift, Alt in that order) and a name,
/// joined by '+': "Ctrl+Shift+Z", "F", "[", "Home", "Escape".
class Bindings {
 public:
  Bindings();

  /// Fails: invalid_argument for an unknown action, or a key that another action has.
  Status bind(std::string_view action_name, const std::string& key);

  std::optional<Action> action_of(const std::string& key) const;
  const std::string& key_of(Action action) const;
  /// Returns all keys of an action: "Ctrl+Shift+Z, Ctrl+Y".
  std::string keys_of(Action action) const;

 private:
  std::optional<Action> bound_to(const std::string& key) const;

  std::map<Action, std::string> keys_;
};

}  // namespace burnish
