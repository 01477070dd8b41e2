// The part of App that hands the window's events on.

#include "client/app/app.h"

namespace burnish {

WindowEvents App::make_events() {
  WindowEvents events;
  events.press = [this](PointerButton button, Modifiers modifiers, const Eigen::Vector2d& pixel) {
    if (workspace_ && workspace_->has_picture() && is_in_picture(pixel))
      workspace_->viewport.press(button, modifiers, in_picture(pixel));
  };
  events.pen = [this](std::optional<double> pressure) {
    if (workspace_) take_pen(pressure);
  };
  events.release = [this](PointerButton button) {
    if (workspace_) workspace_->viewport.release(button);
  };
  events.move = [this](const Eigen::Vector2d& pixel) {
    if (!workspace_ || !workspace_->has_picture()) return;
    if (is_in_picture(pixel) || workspace_->viewport.is_busy()) {
      workspace_->viewport.move(in_picture(pixel));
    } else {
      workspace_->viewport.leave();
    }
  };
  events.wheel = [this](const Eigen::Vector2d& pixel, double steps) {
    if (workspace_ && workspace_->has_picture() && is_in_picture(pixel))
      workspace_->viewport.wheel(in_picture(pixel), steps);
  };
  events.key = [this](const std::string& key) {
    if (workspace_) handle_key(key);
  };
  events.space = [this](bool held) {
    if (workspace_) workspace_->viewport.hold_original = held;
  };
  events.drop = [this](const std::vector<std::filesystem::path>& files) {
    if (workspace_) open_files(files);
  };
  return events;
}

void App::take_pen(std::optional<double> pressure) {
  workspace_->has_pen |= pressure.has_value();
  const bool counts = workspace_->preferences.pen_pressure;
  workspace_->viewport.pressure = counts ? pressure.value_or(1) : 1;
}

static bool lies_within(const Eigen::Vector2d& pixel, const ImVec2& low, const ImVec2& high) {
  return pixel.x() >= low.x && pixel.x() < high.x && pixel.y() >= low.y && pixel.y() < high.y;
}

bool App::is_in_picture(const Eigen::Vector2d& pixel) const {
  const Eigen::Vector2d at = in_picture(pixel);
  if (at.x() < 0 || at.y() < 0 || at.x() >= picture_.size.width || at.y() >= picture_.size.height)
    return false;
  if (shows_help_ || shows_log_ || export_dialog_.is_open() || file_dialog_.is_open()) return false;
  constexpr auto kAnyPopup = ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel;
  if (ImGui::IsPopupOpen("", kAnyPopup)) return false;  // a click beside the popup closes it
  return !lies_within(pixel, toasts_.covered_low, toasts_.covered_high) &&
         !lies_within(pixel, section_window_.covered_low, section_window_.covered_high);
}

Eigen::Vector2d App::in_picture(const Eigen::Vector2d& pixel) const {
  return pixel - Eigen::Vector2d(picture_.x, picture_.y);
}

}  // namespace burnish
