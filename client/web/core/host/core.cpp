// The functions that the worker calls, and the one front of this page.

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "client/model/settings/preferences.h"
#include "client/web/core/front.h"
#include "client/web/core/host/calls.h"
#include "client/web/core/host/clockwork.h"
#include "client/web/core/host/drawing.h"
#include "client/web/core/host/exports.h"
#include "client/web/core/host/imports.h"
#include "client/web/core/host/page_files.h"
#include "client/web/core/host/stacks.h"
#include "client/web/core/json_writer.h"
#include "common/base/atomic_file.h"
#include "common/base/check.h"
#include "common/packing/checksum.h"
#include "common/page_frames/page_frame_header.h"

namespace burnish {

namespace {

using std::chrono::steady_clock;

/// Bytes for the worker, until the end of a function.
class Handed {
 public:
  Handed(uint8_t* memory, size_t bytes) : memory_(memory), bytes_(bytes) {}
  ~Handed() { core_free(memory_); }
  Handed(const Handed&) = delete;
  Handed& operator=(const Handed&) = delete;

  std::string_view text() const { return {reinterpret_cast<const char*>(memory_), bytes_}; }
  std::vector<uint8_t> bytes() const { return {memory_, memory_ + bytes_}; }

 private:
  uint8_t* memory_;
  size_t bytes_;
};

/// Stacks that wait for a picture: those of replayed scripts and of pictures that are saved.
std::vector<int>& waiting_for_picture() {
  static auto* const the = new std::vector<int>();  // lives as long as the page
  return *the;
}

void wait_for_picture(std::chrono::milliseconds) {
  waiting_for_picture().push_back(this_stack());
  host_wake();
  wait_on_stack();
}

/// Returns a host that shows no pictures yet.
FrontHost make_host() {
  FrontHost host;
  host.say = [](const std::string& json) { host_say(json.data(), json.size()); };
  host.give = [](const GivenFile& file) {
    add_page_file(file.name, {file.handle, file.size_bytes});
  };
  host.read = [](const GivenFile& file) -> Result<std::string> {
    static constexpr uint64_t kScriptBytesMax = 64 << 20;
    if (file.size_bytes > kScriptBytesMax)
      return invalid_argument(file.name + ": a script has at most " +
                              std::to_string(kScriptBytesMax) + " bytes");
    return read_page_file({file.handle, file.size_bytes}, 0, file.size_bytes);
  };
  host.download = [](const std::string& name, std::string_view bytes) {
    auto file = AtomicFile::create(name);
    const Status written = file->write(bytes);
    const Status kept = file->commit();
    BURNISH_CHECK(written.is_ok() && kept.is_ok(), "a download takes what it is given");
  };
  host.begin = start_stack;
  host.wait = wait_for_picture;
  return host;
}

/// The renderer and the front, once the page has said `start`.
struct Page {
  std::unique_ptr<PageRenderer> renderer;
  std::unique_ptr<Front> front;
};

Page& page() {
  static Page* const the = new Page();  // lives as long as the page
  return *the;
}

Status begin_page() {
  FrontHost host = make_host();
  WorkspaceOptions options;
  ASSIGN_OR_RETURN(page().renderer, begin_drawing(host, options));
  options.preferences = "window.toml";
  options.wake = host_wake;
  auto preferences = read_preferences(options.preferences);
  page().front = std::make_unique<Front>(
      *page().renderer, preferences.is_ok() ? std::move(*preferences) : Preferences(),
      std::move(options), std::move(host));
  return Status::ok();
}

void say_stopped(const Status& why) {
  JsonWriter json;
  json.open().text("kind", "stopped").text("message", why.message()).close();
  host_say(json.written().data(), json.written().size());
}

double ms_until(steady_clock::time_point when, steady_clock::time_point now) {
  if (when == steady_clock::time_point::max()) return std::numeric_limits<double>::infinity();
  return std::max(0.0, std::chrono::duration<double, std::milli>(when - now).count());
}

}  // namespace

}  // namespace burnish

using namespace burnish;

uint8_t* core_alloc(size_t bytes) {
  return static_cast<uint8_t*>(std::malloc(std::max<size_t>(bytes, 1)));
}

void core_free(uint8_t* memory) {
  std::free(memory);
}

void core_hear(uint8_t* text, size_t bytes) {
  const Handed handed(text, bytes);
  if (!page().front) {
    const Status begun = begin_page();
    if (!begun.is_ok()) return say_stopped(begun);
  }
  page().front->hear(handed.text());
}

double core_tick(double) {
  if (!page().front) return std::numeric_limits<double>::infinity();
  const auto now = steady_clock::now();
  for (const int stack : std::exchange(waiting_for_picture(), {})) resume_stack(stack);
  const auto next =
      std::min({HostCall::look_at_all(now), Clockwork::ask_all(now), page().front->tick(now)});
  return ms_until(next, steady_clock::now());
}

void core_call_message(int call, uint8_t* message, size_t bytes) {
  const Handed handed(message, bytes);
  HostCall::on_message(call, handed.bytes());
}

uint64_t core_frame_checksum(uint8_t* frame, size_t bytes) {
  const Handed handed(frame, bytes);
  return sealed_checksum({frame, bytes}, kPageFrameHeaderBytes - sizeof(uint64_t),
                         kPageFrameHeaderBytes);
}

void core_call_ended(int call, int code, uint8_t* text, size_t bytes, uint8_t* details,
                     size_t details_bytes) {
  const Handed message(text, bytes), rest(details, details_bytes);
  HostCall::on_end(call, {code, std::string(message.text()), std::string(rest.text())});
}
