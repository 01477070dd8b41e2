#include "tests/system/x_display.h"

#include <sstream>
#include <thread>
#include <unistd.h>

#include <X11/XKBlib.h>
#include <X11/Xlib.h>
#include <X11/Xutil.h>
#include <X11/extensions/XTest.h>

#include "common/base/check.h"

namespace burnish {

static constexpr const char* kXvfb = "/usr/bin/Xvfb";
static constexpr std::chrono::seconds kScreenPatience{60};
// Between two events: the window is another process, which handles all of a picture's at once, and
// does not say when.
static constexpr auto kHumanPause = std::chrono::milliseconds(15);

bool XDisplay::is_available() {
  return access(kXvfb, X_OK) == 0;
}

// Finds the display's number in a file that also has warnings: it is the line that is a number.
static std::string announced_display(const std::string& output) {
  std::istringstream lines(output);
  for (std::string line; std::getline(lines, line);)
    if (!line.empty() && !lines.eof() && line.find_first_not_of("0123456789") == std::string::npos)
      return ":" + line;
  return {};
}

XDisplay::XDisplay(const ImageSize& size) : size_(size) {
  const std::string screen = std::to_string(size.width) + "x" + std::to_string(size.height) + "x24";
  server_ = std::make_unique<Process>(std::vector<std::string>{kXvfb, "-displayfd", "1", "-screen",
                                                               "0", screen, "-nolisten", "tcp"},
                                      folder_ / "xvfb.log");
  const auto deadline = std::chrono::steady_clock::now() + kScreenPatience;
  while (name_.empty() && std::chrono::steady_clock::now() < deadline) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    name_ = announced_display(server_->output());
  }
  display_ = XOpenDisplay(name_.c_str());
  BURNISH_CHECK(display_ != nullptr, "no connection to Xvfb: " + server_->output());
}

XDisplay::~XDisplay() {
  if (display_) XCloseDisplay(display_);
}

// Returns the window; 0: none.
unsigned long XDisplay::find_window() {
  Window root = 0, parent = 0, *children = nullptr, found = 0;
  unsigned count = 0;
  XQueryTree(display_, DefaultRootWindow(display_), &root, &parent, &children, &count);
  for (unsigned i = 0; i < count; ++i) {
    XWindowAttributes attributes;
    XGetWindowAttributes(display_, children[i], &attributes);
    if (attributes.map_state == IsViewable && attributes.width > 100) found = children[i];
  }
  if (children) XFree(children);
  return found;
}

bool XDisplay::has_window() {
  return find_window() != 0;
}

void XDisplay::focus_window() {
  const auto deadline = std::chrono::steady_clock::now() + kScreenPatience;
  while (std::chrono::steady_clock::now() < deadline) {
    window_ = find_window();
    if (window_ != 0) break;
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  BURNISH_CHECK(window_ != 0, "no window has come");
  XSetInputFocus(display_, window_, RevertToParent, CurrentTime);
  flush();
}

std::string XDisplay::title() {
  const Atom name = XInternAtom(display_, "_NET_WM_NAME", False);
  const Atom utf8 = XInternAtom(display_, "UTF8_STRING", False);
  Atom type = 0;
  int format = 0;
  unsigned long count = 0, left = 0;
  unsigned char* text = nullptr;
  constexpr long kLongsMax = 256;
  XGetWindowProperty(display_, window_, name, 0, kLongsMax, False, utf8, &type, &format, &count,
                     &left, &text);
  const std::string title(text ? reinterpret_cast<const char*>(text) : "");
  if (text) XFree(text);
  return title;
}

void XDisplay::resize_window(const ImageSize& size) {
  XResizeWindow(display_, window_, size.width, size.height);
  flush();
}

void XDisplay::close_window() {
  XEvent event = {};
  event.xclient.type = ClientMessage;
  event.xclient.window = window_;
  event.xclient.message_type = XInternAtom(display_, "WM_PROTOCOLS", False);
  event.xclient.format = 32;
  event.xclient.data.l[0] = static_cast<long>(XInternAtom(display_, "WM_DELETE_WINDOW", False));
  XSendEvent(display_, window_, False, NoEventMask, &event);
  flush();
}

void XDisplay::flush() {
  XSync(display_, False);
  std::this_thread::sleep_for(kHumanPause);
}

void XDisplay::move(int x, int y) {
  XTestFakeMotionEvent(display_, -1, x, y, CurrentTime);
  flush();
}

void XDisplay::press(int button) {
  XTestFakeButtonEvent(display_, button, True, CurrentTime);
  flush();
}

void XDisplay::release(int button) {
  XTestFakeButtonEvent(display_, button, False, CurrentTime);
  flush();
}

void XDisplay::drag(int from_x, int from_y, int to_x, int to_y, int button) {
  constexpr int kSteps = 12;
  move(from_x, from_y);
  std::this_thread::sleep_for(std::chrono::milliseconds(300));  // the window draws the hover first
  press(button);
  std::this_thread::sleep_for(std::chrono::milliseconds(200));
  for (int step = 1; step <= kSteps; ++step) {
    move(from_x + (to_x - from_x) * step / kSteps, from_y + (to_y - from_y) * step / kSteps);
    std::this_thread::sleep_for(std::chrono::milliseconds(60));
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(200));
  release(button);
}

static KeyCode code_of(_XDisplay* display, const std::string& name) {
  return XKeysymToKeycode(display, XStringToKeysym(name.c_str()));
}

void XDisplay::hold(const std::string& name) {
  XTestFakeKeyEvent(display_, code_of(display_, name), True, CurrentTime);
  flush();
}

void XDisplay::let_go(const std::string& name) {
  XTestFakeKeyEvent(display_, code_of(display_, name), False, CurrentTime);
  flush();
}

void XDisplay::key(const std::vector<std::string>& names) {
  for (const std::string& name : names) hold(name);
  for (auto name = names.rbegin(); name != names.rend(); ++name) let_go(*name);
}

void XDisplay::type(const std::string& text) {
  const KeyCode shift = XKeysymToKeycode(display_, XStringToKeysym("Shift_L"));
  for (const char letter : text) {
    const auto symbol = static_cast<KeySym>(letter);  // Latin letters are their own symbols
    const KeyCode code = XKeysymToKeycode(display_, symbol);
    const bool shifted = XkbKeycodeToKeysym(display_, code, 0, 0) != symbol;
    if (shifted) XTestFakeKeyEvent(display_, shift, True, CurrentTime);
    XTestFakeKeyEvent(display_, code, True, CurrentTime);
    XTestFakeKeyEvent(display_, code, False, CurrentTime);
    if (shifted) XTestFakeKeyEvent(display_, shift, False, CurrentTime);
    flush();
  }
}

Image XDisplay::capture() {
  XImage* const screen = XGetImage(display_, DefaultRootWindow(display_), 0, 0, size_.width,
                                   size_.height, AllPlanes, ZPixmap);
  BURNISH_CHECK(screen != nullptr, "the screen cannot be read");
  Image image{size_, {}};
  image.rgb.reserve(3 * size_t(size_.width) * size_.height);
  for (int y = 0; y < size_.height; ++y) {
    for (int x = 0; x < size_.width; ++x) {
      const unsigned long pixel = XGetPixel(screen, x, y);
      for (int shift : {16, 8, 0}) image.rgb.push_back(static_cast<uint8_t>(pixel >> shift));
    }
  }
  XDestroyImage(screen);
  return image;
}

}  // namespace burnish
