// Loaded into a window under test (LD_PRELOAD): Xvfb has no tablet. It gives X one pen, which
// presses as hard as the file $BURNISH_FAKE_PEN says, 0 to 1. Beside it, the file with .read has a
// byte for each time that the window has asked.

#include <cstdlib>
#include <fstream>
#include <string>

#include <X11/extensions/XInput2.h>

static double value_now() {
  const char* const path = std::getenv("BURNISH_FAKE_PEN");
  double pressure = 0;
  if (path) std::ifstream(path) >> pressure;
  if (path) std::ofstream(std::string(path) + ".read", std::ios::app) << '.';
  return pressure;
}

extern "C" XIDeviceInfo* XIQueryDevice(Display* display, int, int* count) {
  constexpr double kSteps = 2048;
  static XIValuatorClassInfo axis{};
  static XIAnyClassInfo* classes[] = {reinterpret_cast<XIAnyClassInfo*>(&axis)};
  static XIDeviceInfo pen{};
  axis.type = XIValuatorClass;
  axis.label = XInternAtom(display, "Abs Pressure", False);
  axis.max = kSteps;
  axis.value = value_now() * kSteps;
  pen.use = XISlavePointer;
  pen.num_classes = 1;
  pen.classes = classes;
  *count = 1;
  return &pen;
}

extern "C" void XIFreeDeviceInfo(XIDeviceInfo*) {}
