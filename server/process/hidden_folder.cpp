#include "server/process/hidden_folder.h"

#include <algorithm>
#include <mutex>
#include <shared_mutex>
#include <string_view>
#include <utility>

#include <spdlog/spdlog.h>

#include "server/process/line_limiter.h"

namespace burnish {

namespace {

struct Hidden {
  std::shared_mutex mutex;  // guards the following members
  std::string prefix;       // of the paths; empty: nothing is hidden
  std::function<std::string(const std::string&)> scan_name;
};

Hidden& hidden() {
  static Hidden instance;
  return instance;
}

/// The names of our own files have none of these.
constexpr std::string_view kEndsOfPath = " :,;)'\"";
constexpr std::string_view kBeginsOfPath = " ('\"";

// `path`: below the folder.
std::string words_for(std::string_view path) {
  constexpr std::string_view kScans = "scans/", kStaging = "staging/";
  const std::string file(path.substr(path.rfind('/') + 1));
  if (path.starts_with(kStaging)) return "a temporary file";
  if (!path.starts_with(kScans)) return file;
  path.remove_prefix(kScans.size());
  const std::string id(path.substr(0, path.find('/')));
  const std::string scan = "scan " + hidden().scan_name(id);
  return file == id ? scan : file + " of " + scan;
}

bool begins_a_path(std::string_view message, size_t at) {
  return at == 0 || kBeginsOfPath.find(message[at - 1]) != std::string_view::npos;
}

}  // namespace

HiddenFolder::HiddenFolder(const std::filesystem::path& data,
                           std::function<std::string(const std::string&)> scan_name) {
  const std::unique_lock lock(hidden().mutex);
  hidden().prefix = (data / "").string();
  hidden().scan_name = std::move(scan_name);
}

HiddenFolder::~HiddenFolder() {
  const std::unique_lock lock(hidden().mutex);
  hidden().prefix.clear();
  hidden().scan_name = nullptr;
}

std::string text_for_client(const std::string& message) {
  const std::shared_lock lock(hidden().mutex);
  const std::string& prefix = hidden().prefix;
  if (prefix.empty()) return message;
  std::string told;
  size_t done = 0;
  for (size_t at = message.find(prefix); at != std::string::npos; at = message.find(prefix, done)) {
    told += message.substr(done, at - done);
    done = at + prefix.size();
    if (!begins_a_path(message, at)) {
      told += prefix;
      continue;
    }
    const size_t end = std::min(message.find_first_of(kEndsOfPath, done), message.size());
    told += words_for(std::string_view(message).substr(done, end - done));
    done = end;
  }
  told += message.substr(done);
  if (told != message && may_log(LineKind::kEndedCall))
    spdlog::warn("a client is told without the path: {}", message);
  return told;
}

}  // namespace burnish
