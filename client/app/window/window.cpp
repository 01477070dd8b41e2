#include "client/app/window/window.h"

#include <cctype>
#include <imgui.h>

#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>

#include "client/app/widgets/theme.h"
#include "client/app/window/fonts.h"
#include "client/model/input/input_queue.h"

namespace burnish {

// ---- Events of GLFW ----

/// Takes GLFW's events of a window. Input waits in the window's queue until Window::deliver(). The
/// user pointer of the window is a Window.
struct WindowCallbacks {
  static void install(GLFWwindow* window);

  static void press(GLFWwindow* window, int button, int action, int modifiers);
  static void move(GLFWwindow* window, double x, double y);
  static void wheel(GLFWwindow* window, double x, double y);
  static void key(GLFWwindow* window, int key, int scancode, int action, int modifiers);
  static void character(GLFWwindow* window, unsigned code);
  static void drop(GLFWwindow* window, int count, const char** paths);
  static void left(GLFWwindow* window, int entered);
  static void changed(GLFWwindow* window);
  static void lost(GLFWwindow* window);
  static void add(GLFWwindow* window, const InputEvent& event);
};

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

// ---- The window ----

static Status glfw_failure(const std::string& what) {
  const char* why = nullptr;
  glfwGetError(&why);
  return unavailable(what + ": " + (why ? why : "no reason given"));
}

static double screen_scale(GLFWwindow* window) {
  float x = 1, y = 1;
  glfwGetWindowContentScale(window, &x, &y);
  return std::max(1.0f, std::max(x, y));
}

Result<std::unique_ptr<Window>> Window::create(const ImageSize& size, const WindowLook& look,
                                               WindowEvents events) {
  if (!glfwInit()) return glfw_failure("cannot open a window");
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
  GLFWwindow* const handle = glfwCreateWindow(size.width, size.height, "Burnish", nullptr, nullptr);
  if (!handle) {
    Status failure = glfw_failure("cannot open a window with OpenGL 3.3");
    glfwTerminate();
    return failure;
  }
  auto window = std::unique_ptr<Window>(new Window(handle, std::move(events)));
  glfwMakeContextCurrent(handle);
  glfwSwapInterval(1);
  glfwSetWindowUserPointer(handle, window.get());
  Eigen::Vector2d pointer;
  glfwGetCursorPos(handle, &pointer.x(), &pointer.y());
  window->input_.add({.kind = InputEvent::Kind::kMove, .place = pointer});
  ImGui::CreateContext();
  ImGui::GetIO().IniFilename = nullptr;  // Burnish keeps its state in its own file
  ImGui_ImplGlfw_InitForOpenGL(handle, false);
  WindowCallbacks::install(handle);
  ImGui_ImplOpenGL3_Init("#version 330 core");
  window->set_look(look);
  return window;
}

std::string Window::set_look(const WindowLook& look) {
  if (look_ == look) return {};
  const bool is_first = !look_.has_value();
  look_ = look;
  const auto scale = static_cast<float>(look.scale > 0 ? look.scale : screen_scale(window_));
  apply_theme(scale, look.is_light);
  std::string missing = load_fonts(scale, look.letters);
  if (!is_first) {  // the first frame makes the texture itself
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    ImGui_ImplOpenGL3_CreateFontsTexture();
  }
  dirty_ = is_lost_ = true;
  return missing;
}

Window::~Window() {
  ImGui_ImplOpenGL3_Shutdown();
  ImGui_ImplGlfw_Shutdown();
  ImGui::DestroyContext();
  glfwDestroyWindow(window_);
  glfwTerminate();
}

bool Window::take_close_request() {
  const bool is_wanted = glfwWindowShouldClose(window_);
  glfwSetWindowShouldClose(window_, GLFW_FALSE);
  return is_wanted;
}

void Window::close() {
  glfwSetWindowShouldClose(window_, GLFW_TRUE);
}

void Window::hide() {
  glfwHideWindow(window_);
  glfwPollEvents();
}

void Window::wait(double seconds) {
  if (seconds > 0) {
    glfwWaitEventsTimeout(seconds);
  } else {
    glfwPollEvents();
  }
}

void Window::wake() {
  glfwPostEmptyEvent();
}

ImageSize Window::framebuffer_size() const {
  ImageSize size;
  glfwGetFramebufferSize(window_, &size.width, &size.height);
  return size;
}

ImageSize Window::size() const {
  ImageSize size;
  glfwGetWindowSize(window_, &size.width, &size.height);
  return size;
}

void Window::set_title(const std::string& title) {
  glfwSetWindowTitle(window_, title.c_str());
}

Eigen::Vector2d Window::to_pixels(const Eigen::Vector2d& place) const {
  const ImageSize screen = size(), pixels = framebuffer_size();
  return {place.x() * pixels.width / std::max(1, screen.width),
          place.y() * pixels.height / std::max(1, screen.height)};
}

void Window::begin_frame() {
  ImGui_ImplOpenGL3_NewFrame();
  ImGui_ImplGlfw_NewFrame();
  const InputQueue::Pointer& pointer = input_.pointer();
  ImGuiIO& io = ImGui::GetIO();
  io.MousePos = {static_cast<float>(pointer.place.x()), static_cast<float>(pointer.place.y())};
  std::copy(pointer.down.begin(), pointer.down.end(), io.MouseDown);
  ImGui::NewFrame();
}

bool Window::end_frame() {
  ImGui::Render();
  return panels_.take(*ImGui::GetDrawData()) || is_lost_;
}

void Window::show_frame() {
  is_lost_ = false;
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
  glfwSwapBuffers(window_);
}

// ---- Input that it hands on ----

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
    case GLFW_KEY_LEFT:
      return "Left";
    case GLFW_KEY_RIGHT:
      return "Right";
    case GLFW_KEY_UP:
      return "Up";
    case GLFW_KEY_DOWN:
      return "Down";
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
