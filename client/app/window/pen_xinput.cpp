// Asks X for the state of its devices: GLFW takes all events, and tells nothing of a pen's axes.

#include <vector>

#include <X11/extensions/XInput2.h>

#include "client/app/window/pen.h"

// As in GLFW/glfw3native.h, which needs the headers of RandR too.
extern "C" Display* glfwGetX11Display(void);

namespace burnish {

static bool has_xinput2(Display* display) {
  int opcode = 0, event = 0, error = 0, major = 2, minor = 0;
  return XQueryExtension(display, "XInputExtension", &opcode, &event, &error) &&
         XIQueryVersion(display, &major, &minor) == Success;
}

static void add_axes(const XIDeviceInfo& device, Atom label, std::vector<PressureAxis>& axes) {
  for (int i = 0; i < device.num_classes; ++i) {
    if (device.classes[i]->type != XIValuatorClass) continue;
    const auto& axis = *reinterpret_cast<const XIValuatorClassInfo*>(device.classes[i]);
    if (axis.label == label) axes.push_back({axis.min, axis.max, axis.value});
  }
}

// Asks for all devices at once: one that was just unplugged would be an error by its number. A
// master has the axes of the device that moved last, so the devices themselves count.
static std::vector<PressureAxis> pressure_axes() {
  static constexpr const char* kLabel = "Abs Pressure";
  std::vector<PressureAxis> axes;
  Display* const display = glfwGetX11Display();
  if (!display || !has_xinput2(display)) return axes;
  const Atom label = XInternAtom(display, kLabel, False);
  int count = 0;
  XIDeviceInfo* const devices = XIQueryDevice(display, XIAllDevices, &count);
  for (int i = 0; i < count; ++i)
    if (devices[i].use == XISlavePointer) add_axes(devices[i], label, axes);
  if (devices) XIFreeDeviceInfo(devices);
  return axes;
}

std::optional<double> Pen::begin() {
  return gesture_.begin(pressure_axes());
}

std::optional<double> Pen::go_on() {
  if (!gesture_.is_by_pen()) return std::nullopt;
  return gesture_.go_on(pressure_axes());
}

std::string Pen::lack() {
  Display* const display = glfwGetX11Display();
  return display && has_xinput2(display) ? "" : "this screen has no XInput 2";
}

}  // namespace burnish
