#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "client/model/bindings.h"
#include "common/edit/brush.h"

namespace burnish {

inline constexpr size_t kRecentMax = 12;

/// A scan or session that was open, most recent first.
struct RecentSession {
  std::string server;  ///< empty: the private server of this machine
  std::string session;
  std::string scan;  ///< its name
  bool operator==(const RecentSession&) const = default;
};

/// What the window remembers between runs.
struct Preferences {
  std::string user;
  std::string server;  ///< the last one that was typed
  std::vector<RecentSession> recent;
  double brush_radius_part = 0.03;  ///< of the scan's diagonal
  double brush_strength = 0.6;
  double brush_beta = 0;
  double scale = 0;  ///< of fonts and panels; 0: as the screen says
  int window_width = 1280;
  int window_height = 720;
  std::map<std::string, std::string> keys;  ///< action to key, where not the default
};

/// $XDG_CONFIG_HOME/burnish/window.toml, or below ~/.config. Empty without a home.
std::filesystem::path preferences_path();

/// $XDG_DATA_HOME/burnish, or below ~/.local/share: where the private server keeps its scans.
std::filesystem::path private_data_folder();

/// Defaults where there is no file. Fails: invalid_argument naming the file and what is wrong.
Result<Preferences> read_preferences(const std::filesystem::path& path);

/// Makes the folder. Both are for this user alone. Fails: as errno says.
Status write_preferences(const Preferences& preferences, const std::filesystem::path& path);

/// Puts an entry first; forgets the oldest.
void remember(Preferences& preferences, const RecentSession& session);

}  // namespace burnish
