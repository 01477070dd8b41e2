#include "client/app/window/window_callbacks.h"

#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>

#include "client/app/window/window.h"

namespace burnish {

static constexpr double kNowhere = -1e6;  // on no panel

static Window& window_of(GLFWwindow* window) {
  return *static_cast<Window*>(glfwGetWindowUserPointer(window));
}

void WindowCallbacks::add(GLFWwindow* window, const InputEvent& event) {
  Window& self = window_of(window);
  self.dirty_ = true;
  self.input_.add(event);
}

static std::optional<double> pressure_at_button(Pen& pen, int button, bool is_down) {
  if (button != GLFW_MOUSE_BUTTON_LEFT) return pen.go_on();
  if (is_down) return pen.begin();
  pen.end();
  return std::nullopt;
}

void WindowCallbacks::press(GLFWwindow* window, int button, int action, int modifiers) {
  if (button >= kPointerButtons) return changed(window);
  const bool is_down = action == GLFW_PRESS;
  add(window, {.kind = InputEvent::Kind::kButton,
               .code = button,
               .down = is_down,
               .modifiers = modifiers,
               .pressure = pressure_at_button(window_of(window).pen_, button, is_down)});
}

void WindowCallbacks::move(GLFWwindow* window, double x, double y) {
  add(window, {.kind = InputEvent::Kind::kMove,
               .place = {x, y},
               .pressure = window_of(window).pen_.go_on()});
}

void WindowCallbacks::wheel(GLFWwindow* window, double, double y) {
  add(window, {.kind = InputEvent::Kind::kWheel, .steps = y});
}

// Panels repeat a held key by their own clock.
void WindowCallbacks::key(GLFWwindow* window, int key, int scancode, int action, int modifiers) {
  if (action == GLFW_REPEAT) return changed(window);
  add(window, {.kind = InputEvent::Kind::kKey,
               .code = key,
               .down = action == GLFW_PRESS,
               .modifiers = modifiers,
               .scancode = scancode});
}

void WindowCallbacks::character(GLFWwindow* window, unsigned code) {
  add(window, {.kind = InputEvent::Kind::kCharacter, .code = static_cast<int>(code)});
}

void WindowCallbacks::drop(GLFWwindow* window, int count, const char** paths) {
  Window& self = window_of(window);
  self.dirty_ = true;
  self.events_.drop({paths, paths + count});
}

void WindowCallbacks::left(GLFWwindow* window, int entered) {
  ImGui_ImplGlfw_CursorEnterCallback(window, entered);
  if (entered) return changed(window);
  add(window, {.kind = InputEvent::Kind::kLeave, .place = {kNowhere, kNowhere}});
}

void WindowCallbacks::changed(GLFWwindow* window) {
  window_of(window).dirty_ = true;
}

void WindowCallbacks::lost(GLFWwindow* window) {
  window_of(window).is_lost_ = true;
  changed(window);
}

void WindowCallbacks::install(GLFWwindow* window) {
  glfwSetMouseButtonCallback(window, press);
  glfwSetCursorPosCallback(window, move);
  glfwSetScrollCallback(window, wheel);
  glfwSetKeyCallback(window, key);
  glfwSetCharCallback(window, character);
  glfwSetDropCallback(window, drop);
  glfwSetWindowRefreshCallback(window, lost);
  glfwSetFramebufferSizeCallback(window, [](GLFWwindow* one, int, int) { lost(one); });
  glfwSetWindowFocusCallback(window, [](GLFWwindow* one, int focused) {
    ImGui_ImplGlfw_WindowFocusCallback(one, focused);
    changed(one);
  });
  glfwSetCursorEnterCallback(window, left);
}

}  // namespace burnish
