#include "client/app/window/window.h"

#include <imgui.h>

#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>

#include "client/app/widgets/theme.h"
#include "client/app/window/fonts.h"
#include "client/app/window/window_callbacks.h"

namespace burnish {

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

}  // namespace burnish
