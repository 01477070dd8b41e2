#pragma once

struct GLFWwindow;

namespace burnish {

/// Turns GLFW's events of a window into WindowEvents. The user pointer of the window is a Window.
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
};

}  // namespace burnish
