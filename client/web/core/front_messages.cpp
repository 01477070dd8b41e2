// The part of Front that hears the page's messages.

#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include "client/web/core/front.h"

namespace burnish {

namespace {

using Json = nlohmann::json;

std::string text_in(const Json& message, const char* name) {
  const auto found = message.find(name);
  return found != message.end() && found->is_string() ? found->get<std::string>() : std::string();
}

double number_in(const Json& message, const char* name, double otherwise = 0) {
  const auto found = message.find(name);
  return found != message.end() && found->is_number() ? found->get<double>() : otherwise;
}

bool flag_in(const Json& message, const char* name) {
  const auto found = message.find(name);
  return found != message.end() && found->is_boolean() && found->get<bool>();
}

int whole_in(const Json& message, const char* name) {
  return static_cast<int>(std::clamp(number_in(message, name), 0.0, 1e9));
}

ImageSize size_in(const Json& message) {
  return {whole_in(message, "width"), whole_in(message, "height")};
}

GivenFile file_in(const Json& message) {
  const auto found = message.find("file");
  if (found == message.end() || !found->is_object()) return {};
  return {whole_in(*found, "handle"), text_in(*found, "name"),
          static_cast<uint64_t>(std::max(0.0, number_in(*found, "size")))};
}

/// Returns "HOST:PORT" for the page's origin.
std::string server_of_origin(const std::string& origin) {
  const size_t scheme = origin.find("://");
  return scheme == std::string::npos ? origin : origin.substr(scheme + 3);
}

Modifiers modifiers_of(int sum) {
  return {.shift = (sum & 1) != 0, .control = (sum & 2) != 0, .alt = (sum & 4) != 0};
}

PointerButton button_of(int number) {
  if (number == 1) return PointerButton::kMiddle;
  return number == 2 ? PointerButton::kRight : PointerButton::kLeft;
}

// A step of the wheel and a spread of two fingers are the same zoom.
double steps_of_pinch(double ratio) {
  constexpr double kRatioOfStep = 1.15;
  return ratio > 0 ? std::log(ratio) / std::log(kRatioOfStep) : 0;
}

void hear_pointer(const Json& message, Workspace& workspace) {
  if (!workspace.has_picture()) return;
  Viewport& viewport = workspace.viewport;
  const std::string what = text_in(message, "what");
  const Eigen::Vector2d pixel(number_in(message, "x"), number_in(message, "y"));
  const PointerButton button = button_of(whole_in(message, "button"));
  const bool is_pen = flag_in(message, "pen");
  workspace.has_pen |= is_pen;
  const bool counts = is_pen && workspace.preferences.pen_pressure;
  viewport.pressure = counts ? std::clamp(number_in(message, "pressure", 1), 0.0, 1.0) : 1;
  if (what == "press") viewport.press(button, modifiers_of(whole_in(message, "modifiers")), pixel);
  if (what == "move") viewport.move(pixel);
  if (what == "release") viewport.release(button);
  if (what == "leave") viewport.leave();
  if (what == "wheel") viewport.wheel(pixel, number_in(message, "delta"));
  if (what == "pinch") viewport.wheel(pixel, steps_of_pinch(number_in(message, "delta")));
}

}  // namespace

void Front::hear(std::string_view json) {
  const Json message = Json::parse(json, nullptr, false);
  if (!message.is_object())
    return answer("", invalid_argument("a message of the page is not JSON"));
  const std::string kind = text_in(message, "kind");
  said_at_ = {};  // the page waits for what becomes of it
  if (kind == "start") state_.server = server_of_origin(text_in(message, "address"));
  if (kind == "start" || kind == "resize") {
    workspace_.viewport.set_size(size_in(message));
    workspace_.viewport.pixel_ratio = number_in(message, "pixelRatio");
  }
  if (kind == "start" || kind == "connect") {
    workspace_.preferences.user = text_in(message, "user");
    workspace_.connect(KnownServer{.address = state_.server, .token = text_in(message, "token")});
  }
  if (kind == "pointer") hear_pointer(message, workspace_);
  if (kind == "command") do_line(text_in(message, "line"));
  if (kind == "visible") {
    is_visible_ = flag_in(message, "is");
    if (!is_visible_) {  // it may be closed now, and has no more pictures
      workspace_.keep_session_picture();
      workspace_.strip.close(workspace_.document());
    }
  }
  if (kind == "lost") {  // another core goes on
    is_visible_ = false;
    workspace_.strip.close(workspace_.document());
    workspace_.save_preferences();
  }
  if (kind == "resize") shown_ = {};  // a canvas of another size is empty
  if (kind == "import") {
    const GivenFile file = file_in(message);
    host_.give(file);
    workspace_.import_in_place(file.name);
  }
  if (kind == "replay") replay(file_in(message));
}

}  // namespace burnish
