#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "client/model/settings/known_servers.h"
#include "client/model/settings/recent_sessions.h"
#include "client/scene/lighting.h"
#include "common/edit/brush.h"

namespace burnish {

/// State that the window keeps between runs.
struct Preferences {
  std::string user;
  std::vector<KnownServer> servers;  ///< latest first; a token is written only if it is kept
  std::vector<RecentSession> recent;
  std::vector<std::filesystem::path> folders;  ///< of files that were opened or saved, latest first
  bool native_dialogs = true;                  ///< the desktop's file dialogs, where there are some
  double brush_radius_part = 0.03;             ///< of the scan's diagonal
  double brush_strength = 0.6;
  double brush_beta = 0;
  bool pen_pressure = true;  ///< scales the brush's strength
  bool light_theme = false;
  double scale = 0;   ///< of fonts and panels; 0: the screen's scale
  Lighting lighting;  ///< of scans that are shown for the first time
  int window_width = 1280;
  int window_height = 720;
  std::map<std::string, std::string> keys;  ///< action to key, if not the default
};

/// Returns $XDG_CONFIG_HOME/burnish/window.toml, or the same below ~/.config. Empty without a home.
std::filesystem::path preferences_path();

/// Returns defaults if there is no file. Fails: invalid_argument that names the file and the error.
Result<Preferences> read_preferences(const std::filesystem::path& path);

inline constexpr size_t kRecentFoldersMax = 6;

/// Puts a folder first and drops the oldest.
void remember_folder(Preferences& preferences, const std::filesystem::path& folder);

/// Writes the file and makes its folder; only this user can read them. Fails: as errno says.
Status write_preferences(const Preferences& preferences, const std::filesystem::path& path);

}  // namespace burnish
