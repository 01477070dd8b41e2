#include "client/model/input/bindings.h"

#include <algorithm>

namespace burnish {

const std::array<ActionInfo, kActions>& actions() {
  static const std::array<ActionInfo, kActions> kInfos = {{
      {Action::kOpen, "open", "Ctrl+O", "Open a scan"},
      {Action::kUndo, "undo", "Ctrl+Z", "Undo your last edit"},
      {Action::kRedo, "redo", "Ctrl+Shift+Z", "Redo it", "Ctrl+Y"},
      {Action::kFrameAll, "frame_all", "Home", "Show the whole scan"},
      {Action::kFocus, "focus", "C", "Turn around the point under the cursor"},
      {Action::kBrushRadius, "brush_radius", "F", "Move the mouse to set the brush's radius"},
      {Action::kBrushStrength, "brush_strength", "Shift+F",
       "Move the mouse to set the brush's strength"},
      {Action::kRadiusDown, "radius_down", "[", "Smaller brush"},
      {Action::kRadiusUp, "radius_up", "]", "Larger brush"},
      {Action::kNavigateMode, "navigate_mode", "N", "Left button turns instead of painting"},
      {Action::kMeasureMode, "measure_mode", "M", "Left button measures distances"},
      {Action::kWireframe, "wireframe", "W", "Show the triangles' edges"},
      {Action::kSplit, "split", "S", "Original on the left, edited on the right"},
      {Action::kExport, "export", "Ctrl+E", "Export the edited scan"},
      {Action::kScreenshot, "screenshot", "F12", "Save a picture of the surface"},
      {Action::kBookmark, "bookmark", "B", "Remember this view"},
      {Action::kFront, "front", "1", "View from the front"},
      {Action::kBack, "back", "Ctrl+1", "View from the back"},
      {Action::kRight, "right", "3", "View from the right"},
      {Action::kLeft, "left", "Ctrl+3", "View from the left"},
      {Action::kTop, "top", "7", "View from above"},
      {Action::kBottom, "bottom", "Ctrl+7", "View from below"},
      {Action::kOrthographic, "orthographic", "5", "With or without perspective"},
      {Action::kTurnLeft, "turn_left", "Left", "Turn the view to the left"},
      {Action::kTurnRight, "turn_right", "Right", "Turn the view to the right"},
      {Action::kTurnUp, "turn_up", "Up", "Turn the view upwards"},
      {Action::kTurnDown, "turn_down", "Down", "Turn the view downwards"},
      {Action::kLog, "log", "L", "Show all messages"},
      {Action::kHelp, "help", "?", "Show the keys"},
      {Action::kSave, "save", "Ctrl+S", "Say whether all edits are saved"},
      {Action::kQuit, "quit", "Ctrl+Q", "Quit"},
      {Action::kCancel, "cancel", "Escape", "Cancel the stroke; close what is open"},
  }};
  return kInfos;
}

Bindings::Bindings() {
  for (const ActionInfo& info : actions()) keys_[info.action] = info.key;
}

Status Bindings::bind(std::string_view action_name, const std::string& key) {
  const auto info = std::find_if(actions().begin(), actions().end(),
                                 [&](const ActionInfo& one) { return one.name == action_name; });
  if (info == actions().end())
    return invalid_argument("keys: unknown action '" + std::string(action_name) + "'");
  const auto other = bound_to(key);
  if (other && *other != info->action)
    return invalid_argument("keys: '" + key + "' is given to '" + std::string(action_name) +
                            "' and to another action");
  keys_[info->action] = key;
  return Status::ok();
}

std::optional<Action> Bindings::bound_to(const std::string& key) const {
  for (const auto& [action, bound] : keys_)
    if (bound == key) return action;
  return std::nullopt;
}

std::optional<Action> Bindings::action_of(const std::string& key) const {
  if (const auto action = bound_to(key)) return action;
  for (const ActionInfo& info : actions())
    if (!key.empty() && info.also == key) return info.action;
  return std::nullopt;
}

std::string Bindings::keys_of(Action action) const {
  std::string keys = key_of(action);
  for (const ActionInfo& info : actions())
    if (info.action == action && !info.also.empty() && action_of(std::string(info.also)) == action)
      keys += ", " + std::string(info.also);
  return keys;
}

const std::string& Bindings::key_of(Action action) const {
  return keys_.at(action);
}

}  // namespace burnish
