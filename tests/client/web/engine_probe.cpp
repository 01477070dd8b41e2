// Stands for the cores in tests of the engine: does what a line says, and tells of it. DRAWN_BY
// says which core it is.

#include <cstdlib>
#include <cstring>
#include <string>
#include <string_view>

#define IMPORT(name) extern "C" __attribute__((import_module("host"), import_name(#name)))
#define EXPORT(name) extern "C" __attribute__((export_name(#name)))

IMPORT(say) void say(const char* text, size_t length);
IMPORT(wake) void wake();
IMPORT(task_start) void task_start(int task);
IMPORT(task_suspend) void task_suspend(int task);
IMPORT(task_resume) void task_resume(int task);
IMPORT(file_size) double file_size(int file);
IMPORT(file_read) size_t file_read(int file, double offset, char* to, size_t room);
IMPORT(download_begin) int download_begin(const char* name, size_t length);
IMPORT(download_add) void download_add(int download, const char* bytes, size_t length);
IMPORT(download_end) void download_end(int download, int keep);
IMPORT(store_set)
void store_set(const char* key, size_t key_length, const char* text, size_t length);
IMPORT(store_get) size_t store_get(const char* key, size_t length);
IMPORT(store_take) void store_take(char* to);

IMPORT(picture_keep)
void picture_keep(const char* key, size_t key_length, const char* rgb, int width, int height);

IMPORT(image_decode)
int image_decode(const char* file, size_t bytes, int width, int height);

namespace {

constexpr int kTasks = 3, kDepth = 20, kWaits = 5;
constexpr size_t kStackBytes = 1 << 16;
char* stacks[kTasks];
bool draws = false;

void tell(const std::string& message) {
  const std::string json = R"({"kind":"answer","line":"","message":")" + message + "\"}";
  say(json.data(), json.size());
}

// Fills frames of its stack, waits at the bottom, and returns how many frames are as they were.
int wait_below(int task, int depth) {
  char frame[1000];
  std::memset(frame, task + 1, sizeof(frame));
  asm volatile("" : : "r"(frame) : "memory");
  int kept = 0;
  if (depth > 0) {
    kept = wait_below(task, depth - 1);
  } else {
    for (int i = 0; i < kWaits; ++i) task_suspend(task);
  }
  for (const char byte : frame)
    if (byte != task + 1) return kept;
  return kept + 1;
}

// What stands behind a word of a message, to the next sign that ends it.
std::string_view behind(std::string_view message, std::string_view word) {
  const size_t at = message.find(word);
  if (at == std::string_view::npos) return {};
  const std::string_view rest = message.substr(at + word.size());
  return rest.substr(0, rest.find_first_of("\",}"));
}

void read_file(int file) {
  std::string bytes(size_t(file_size(file)), '\0');
  const size_t got = file_read(file, 2, bytes.data(), bytes.size());
  tell("from 2: " + bytes.substr(0, got));
}

void decode(int file, int width, int height) {
  std::string bytes(size_t(file_size(file)), '\0');
  file_read(file, 0, bytes.data(), bytes.size());
  image_decode(bytes.data(), bytes.size(), width, height);
}

void download(bool is_kept) {
  const int file = download_begin("a.txt", 5);
  for (const char* part : {"one ", "two"}) download_add(file, part, std::strlen(part));
  download_end(file, is_kept);
}

void obey(std::string_view line) {
  if (line == "tasks")
    for (int task = 0; task < kTasks; ++task) task_start(task);
  if (line == "resume")
    for (int task = kTasks - 1; task >= 0; --task) task_resume(task);
  if (line == "draw") draws = true;
  if (line == "download") download(true);
  if (line == "drop") download(false);
  if (line == "store") store_set("key", 3, "kept text", 9);
  if (line == "picture") picture_keep("shown", 5, "\x10\x20\x30\xf0\x80\x08", 2, 1);
  if (line == "who") tell("drawn by the " DRAWN_BY);
  if (line == "trap") std::abort();
  wake();
}

}  // namespace

EXPORT(core_alloc) void* core_alloc(size_t bytes) {
  return std::malloc(bytes + 1);
}

EXPORT(core_stack) char* core_stack(int task) {
  stacks[task] = static_cast<char*>(std::malloc(kStackBytes));
  return stacks[task] + kStackBytes;
}

EXPORT(core_task) void core_task(int task) {
  tell("task " + std::to_string(task) + " kept " + std::to_string(wait_below(task, kDepth)));
}

EXPORT(core_hear) void core_hear(char* text, size_t length) {
  const std::string message(text, length);
  std::free(text);
  const std::string_view kind = behind(message, "\"kind\":\"");
  if (kind == "start") {
    std::string kept(store_get("key", 3), '\0');
    store_take(kept.data());
    tell("started with '" + kept + "'");
  }
  if (kind == "resize") tell("resized to " + std::string(behind(message, "\"width\":")));
  if (kind == "command") obey(behind(message, "\"line\":\""));
  if (kind == "import") {
    const int file = std::atoi(std::string(behind(message, "\"handle\":")).c_str());
    if (behind(message, "\"name\":\"") == "8x4.webp") {
      decode(file, 8, 4);
      decode(file, 8, 5);
    } else {
      read_file(file);
    }
  }
}

EXPORT(core_tick) double core_tick(double) {
  if (draws) tell("ticked");
  draws = false;
  return 1e9;
}

EXPORT(core_image_decoded) void core_image_decoded(int image, unsigned char* rgba) {
  std::string said = "image " + std::to_string(image) + ":";
  if (rgba == nullptr) said += " none";
  for (int i = 0; rgba != nullptr && i < 4; ++i) said += " " + std::to_string(rgba[i]);
  tell(said);
  std::free(rgba);
}

EXPORT(core_call_message) void core_call_message(int, char* bytes, size_t) {
  std::free(bytes);
}

EXPORT(core_call_ended) void core_call_ended(int, int, char* text, size_t, char* details, size_t) {
  std::free(text);
  std::free(details);
}
