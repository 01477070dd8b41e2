#pragma once

#include <filesystem>

namespace burnish {

// Folders of the user who runs the program. All are empty where the environment names no home.

/// Returns $HOME.
std::filesystem::path home_folder();

/// Returns $XDG_CONFIG_HOME/burnish, or the same below ~/.config.
std::filesystem::path config_folder();

/// Returns $XDG_CACHE_HOME/burnish, or the same below ~/.cache.
std::filesystem::path cache_folder();

/// Returns $XDG_DATA_HOME/burnish, or the same below ~/.local/share.
std::filesystem::path data_folder();

}  // namespace burnish
