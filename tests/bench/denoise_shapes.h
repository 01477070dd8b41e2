#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tests/bench/denoise_filter.h"

namespace burnish {

/// Writes clean.ply, noisy.ply and our results, ours-PRESET.ply and ours-auto.ply, into the folder
/// FOLDER/SHAPE NOISE, for tests/bench/denoise_peers. Fails: as filtering and writing do.
Status write_shape(const NoisyShape& shape, const std::filesystem::path& folder);

/// Prints a line "ANGLE DISTANCE" for each file against the clean one: the errors of the tables.
/// Fails: for a file that cannot be read, or has other triangles.
Status print_errors(const std::vector<std::string>& clean_and_others);

}  // namespace burnish
