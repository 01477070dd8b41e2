#pragma once

#include <filesystem>
#include <vector>

#include "client/tools/presets.h"

namespace burnish {

inline constexpr size_t kOwnPresetsMax = 100;

/// Returns the file of the user's own presets: $XDG_CONFIG_HOME/burnish/presets, or the same below
/// ~/.config. A line is BETA, a curve K:A,K:A,..., perhaps bands=A:GAIN,A:GAIN,... from fine to
/// coarse, and a name. Empty without a home.
std::filesystem::path own_presets_path();

/// Returns no presets if there is no file. Fails: invalid_argument that names the line.
Result<std::vector<Preset>> read_own_presets(const std::filesystem::path& path);

/// Adds a preset, or replaces the one of its name, in a file whose folder this makes. Fails:
/// invalid_argument for a name that is not printable, ends with a number or belongs to presets();
/// resource_exhausted above kOwnPresetsMax; as read_own_presets(); as errno says.
Status save_own_preset(const std::filesystem::path& path, const Preset& preset);

/// Fails: not_found; as save_own_preset().
Status delete_own_preset(const std::filesystem::path& path, const std::string& name);

/// Returns one of presets() or of the user's own. Fails: not_found; as read_own_presets().
Result<Preset> find_any_preset(const std::string& name);

// The store of the presets: own_presets_file.cpp, or that of a browser's page.

/// Returns no text if there is no file. Fails: as errno says.
Result<std::string> read_own_presets_text(const std::filesystem::path& path);
/// Makes the folder too. Fails: as errno says.
Status write_own_presets_text(const std::filesystem::path& path, const std::string& text);

}  // namespace burnish
