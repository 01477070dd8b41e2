#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace burnish {

/// While it lives, clients are not told where the server keeps its files. One at a time.
class HiddenFolder {
 public:
  /// `scan_name`: returns the name of the scan with this id. Called from any thread.
  HiddenFolder(const std::filesystem::path& data,
               std::function<std::string(const std::string&)> scan_name);
  ~HiddenFolder();
  HiddenFolder(const HiddenFolder&) = delete;
  HiddenFolder& operator=(const HiddenFolder&) = delete;
};

/// Returns a message as clients get it: paths below the hidden folder become "pages of scan igea",
/// "a temporary file" or the file's name. Logs the whole message if it names one. Thread-safe.
std::string text_for_client(const std::string& message);

}  // namespace burnish
