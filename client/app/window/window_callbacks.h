#pragma once

#include "client/model/input/input_queue.h"

struct GLFWwindow;

namespace burnish {

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

}  // namespace burnish
