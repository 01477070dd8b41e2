// Drag and drop like a file manager: the source's side of the XDND protocol, version 5.

#include <thread>

#include "common/base/check.h"
#include "tests/system/x_display.h"
// Included last: it has macros with our names.
#include <X11/Xlib.h>

namespace burnish {
namespace {

constexpr std::chrono::seconds kDropPatience{60};
constexpr long kXdndVersion = 5;

/// A drop from its own hidden window onto another window.
class Drop {
 public:
  Drop(Display* display, Window target, std::string uris)
      : display_(display),
        target_(target),
        source_(XCreateSimpleWindow(display, DefaultRootWindow(display), 0, 0, 1, 1, 0, 0, 0)),
        uris_(std::move(uris)) {
    XSetSelectionOwner(display_, atom("XdndSelection"), source_, CurrentTime);
  }
  ~Drop() { XDestroyWindow(display_, source_); }

  void perform(int x, int y) {
    send("XdndEnter", kXdndVersion << 24, static_cast<long>(atom("text/uri-list")), 0);
    send("XdndPosition", 0, long{x} << 16 | y, CurrentTime,
         static_cast<long>(atom("XdndActionCopy")));
    serve_until("XdndStatus");
    send("XdndDrop", 0, CurrentTime, 0);
    serve_until("XdndFinished");
  }

 private:
  Atom atom(const char* name) const { return XInternAtom(display_, name, False); }

  void send(const char* message, long b, long c, long d, long e = 0) const {
    XEvent event = {};
    event.xclient.type = ClientMessage;
    event.xclient.window = target_;
    event.xclient.message_type = atom(message);
    event.xclient.format = 32;
    const long data[] = {static_cast<long>(source_), b, c, d, e};
    std::copy(std::begin(data), std::end(data), event.xclient.data.l);
    XSendEvent(display_, target_, False, NoEventMask, &event);
    XFlush(display_);
  }

  // Sends the names on request until this answer comes.
  void serve_until(const char* answer) const {
    const auto deadline = std::chrono::steady_clock::now() + kDropPatience;
    while (std::chrono::steady_clock::now() < deadline) {
      XEvent event;
      if (XCheckTypedWindowEvent(display_, source_, SelectionRequest, &event))
        give(event.xselectionrequest);
      if (XCheckTypedWindowEvent(display_, source_, ClientMessage, &event) &&
          event.xclient.message_type == atom(answer))
        return;
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    BURNISH_CHECK(false, std::string("no ") + answer + " has come");
  }

  void give(const XSelectionRequestEvent& request) const {
    XChangeProperty(display_, request.requestor, request.property, request.target, 8,
                    PropModeReplace, reinterpret_cast<const unsigned char*>(uris_.data()),
                    static_cast<int>(uris_.size()));
    XEvent event = {};
    event.xselection.type = SelectionNotify;
    event.xselection.requestor = request.requestor;
    event.xselection.selection = request.selection;
    event.xselection.target = request.target;
    event.xselection.property = request.property;
    event.xselection.time = request.time;
    XSendEvent(display_, request.requestor, False, NoEventMask, &event);
    XFlush(display_);
  }

  Display* display_;
  Window target_;
  Window source_;
  std::string uris_;
};

}  // namespace

void XDisplay::drop(const std::vector<std::filesystem::path>& files) {
  std::string uris;
  for (const auto& file : files) uris += "file://" + file.string() + "\r\n";
  Drop(display_, window_, uris).perform(size_.width / 2, size_.height / 2);
}

}  // namespace burnish
