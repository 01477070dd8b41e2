#include <cctype>
#include <imgui.h>

#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>

#include "client/app/window/window.h"

namespace burnish {

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

void Window::deliver() {
  for (const InputEvent& event : input_.next()) deliver(event);
  dirty_ |= input_.has_more();
}

void Window::deliver(const InputEvent& event) {
  switch (event.kind) {
    case InputEvent::Kind::kMove:
      events_.pen(event.pressure);
      return events_.move(to_pixels(event.place));
    case InputEvent::Kind::kLeave:
      return;
    case InputEvent::Kind::kButton:
      return deliver_button(event);
    case InputEvent::Kind::kWheel:
      ImGui_ImplGlfw_ScrollCallback(window_, 0, event.steps);
      return events_.wheel(to_pixels(event.place), event.steps);
    case InputEvent::Kind::kKey:
      ImGui_ImplGlfw_KeyCallback(window_, event.code, event.scancode,
                                 event.down ? GLFW_PRESS : GLFW_RELEASE, event.modifiers);
      return deliver_key(event);
    case InputEvent::Kind::kCharacter:
      ImGui_ImplGlfw_CharCallback(window_, static_cast<unsigned>(event.code));
      return deliver_character(event.code);
  }
}

void Window::deliver_button(const InputEvent& event) {
  const Modifiers held{(event.modifiers & GLFW_MOD_SHIFT) != 0,
                       (event.modifiers & GLFW_MOD_CONTROL) != 0,
                       (event.modifiers & GLFW_MOD_ALT) != 0};
  if (event.down) {
    events_.pen(event.pressure);
    events_.press(button_of(event.code), held, to_pixels(event.place));
  } else {
    events_.release(button_of(event.code));
  }
}

void Window::deliver_key(const InputEvent& event) {
  const bool is_typing = ImGui::GetIO().WantTextInput;
  if (event.code == GLFW_KEY_SPACE) return events_.space(event.down && !is_typing);
  if (!event.down || is_typing) return;
  const std::string name = key_name(event.code, event.scancode);
  if (!name.empty()) events_.key(with_modifiers(name, event.modifiers));
}

void Window::deliver_character(int code) {
  if (ImGui::GetIO().WantTextInput || code > 126 || !std::ispunct(code)) return;
  events_.key(std::string(1, static_cast<char>(code)));
}

}  // namespace burnish
