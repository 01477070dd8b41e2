#include "client/app/window_callbacks.h"

#include <cctype>
#include <imgui.h>

#include <GLFW/glfw3.h>

#include "client/app/window.h"

namespace burnish {

static constexpr double kNowhere = -1e6;  // on no panel

static Window& window_of(GLFWwindow* window) {
  return *static_cast<Window*>(glfwGetWindowUserPointer(window));
}

// Names keys other than letters and digits by their character, not by their place: '?' and '[' are
// elsewhere on other keyboards.
static std::string key_name(int key, int scancode) {
  switch (key) {
    case GLFW_KEY_HOME:
      return "Home";
    case GLFW_KEY_END:
      return "End";
    case GLFW_KEY_ESCAPE:
      return "Escape";
    case GLFW_KEY_DELETE:
      return "Delete";
    case GLFW_KEY_TAB:
      return "Tab";
    default:
      break;
  }
  if (key >= GLFW_KEY_F1 && key <= GLFW_KEY_F12) return "F" + std::to_string(key - GLFW_KEY_F1 + 1);
  const char* const name = glfwGetKeyName(key, scancode);
  if (!name || !std::isalnum(static_cast<unsigned char>(name[0])) || name[1] != 0) return {};
  return std::string(1, static_cast<char>(std::toupper(static_cast<unsigned char>(name[0]))));
}

static std::string with_modifiers(const std::string& name, int modifiers) {
  std::string chord;
  if (modifiers & GLFW_MOD_CONTROL) chord += "Ctrl+";
  if (modifiers & GLFW_MOD_SHIFT) chord += "Shift+";
  if (modifiers & GLFW_MOD_ALT) chord += "Alt+";
  return chord + name;
}

static PointerButton button_of(int button) {
  if (button == GLFW_MOUSE_BUTTON_MIDDLE) return PointerButton::kMiddle;
  return button == GLFW_MOUSE_BUTTON_RIGHT ? PointerButton::kRight : PointerButton::kLeft;
}

// When pictures take long, events come in bulk. The pointer's place at the press is the last move
// before it, not its place now.
void WindowCallbacks::press(GLFWwindow* window, int button, int action, int modifiers) {
  Window& self = window_of(window);
  self.dirty_ = true;
  if (button >= kPointerButtons) return;
  self.pointer_.press(button, action == GLFW_PRESS);
  const Modifiers held{(modifiers & GLFW_MOD_SHIFT) != 0, (modifiers & GLFW_MOD_CONTROL) != 0,
                       (modifiers & GLFW_MOD_ALT) != 0};
  if (action == GLFW_PRESS) {
    self.events_.press(button_of(button), held, self.to_pixels(self.pointer_.place()));
  } else {
    self.events_.release(button_of(button));
  }
}

void WindowCallbacks::move(GLFWwindow* window, double x, double y) {
  Window& self = window_of(window);
  self.dirty_ = true;
  self.pointer_.move({x, y});
  self.events_.move(self.to_pixels({x, y}));
}

void WindowCallbacks::wheel(GLFWwindow* window, double, double y) {
  Window& self = window_of(window);
  self.dirty_ = true;
  self.events_.wheel(self.to_pixels(self.pointer_.place()), y);
}

void WindowCallbacks::key(GLFWwindow* window, int key, int scancode, int action, int modifiers) {
  Window& self = window_of(window);
  self.dirty_ = true;
  if (key == GLFW_KEY_SPACE && action != GLFW_REPEAT) {
    self.events_.space(action == GLFW_PRESS && !ImGui::GetIO().WantTextInput);
    return;
  }
  if (action != GLFW_PRESS || ImGui::GetIO().WantTextInput) return;
  const std::string name = key_name(key, scancode);
  if (!name.empty()) self.events_.key(with_modifiers(name, modifiers));
}

void WindowCallbacks::character(GLFWwindow* window, unsigned code) {
  Window& self = window_of(window);
  self.dirty_ = true;
  if (ImGui::GetIO().WantTextInput || code > 126 || !std::ispunct(static_cast<int>(code))) return;
  self.events_.key(std::string(1, static_cast<char>(code)));
}

void WindowCallbacks::drop(GLFWwindow* window, int count, const char** paths) {
  Window& self = window_of(window);
  self.dirty_ = true;
  self.events_.drop({paths, paths + count});
}

void WindowCallbacks::left(GLFWwindow* window, int entered) {
  Window& self = window_of(window);
  self.dirty_ = true;
  if (!entered) self.pointer_.move({kNowhere, kNowhere});
}

void WindowCallbacks::changed(GLFWwindow* window) {
  window_of(window).dirty_ = true;
}

void WindowCallbacks::install(GLFWwindow* window) {
  glfwSetMouseButtonCallback(window, press);
  glfwSetCursorPosCallback(window, move);
  glfwSetScrollCallback(window, wheel);
  glfwSetKeyCallback(window, key);
  glfwSetCharCallback(window, character);
  glfwSetDropCallback(window, drop);
  glfwSetWindowRefreshCallback(window, changed);
  glfwSetFramebufferSizeCallback(window, [](GLFWwindow* one, int, int) { changed(one); });
  glfwSetWindowFocusCallback(window, [](GLFWwindow* one, int) { changed(one); });
  glfwSetCursorEnterCallback(window, left);
}

}  // namespace burnish
