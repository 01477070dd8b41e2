#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "common/base/status.h"

namespace burnish {

/// The table of layers.txt: it says which part of the tree may depend on which.
struct Layers {
  std::map<std::string, std::set<std::string>> allowed;  ///< by layer or part: what it names
  std::set<std::string> parts;                           ///< each lies in its layer's folder
  std::map<std::string, std::set<std::string>> only;     ///< by foreign prefix: its allowed users

  /// Returns the layer of a path below the root: the longest one that is the path, its folder or
  /// its stem.
  std::optional<std::string> layer_of(const std::string& path) const;

  /// Returns the layer that a part lies in, and any other layer itself.
  std::string whole_of(const std::string& layer) const;

  /// Returns nothing if a file of `layer` may use `name`, an include path or a CMake target; else
  /// the reason.
  std::string objection(const std::string& layer, const std::string& name) const;
};

/// Fails: invalid_argument that names the line, for unknown words, and for a layer that names one
/// below it, or a part of another, so that no circle can be declared.
Result<Layers> read_layers(const std::filesystem::path& table);

/// Checks every `#include "..."` and `#include <...>` of the sources below root/folder for each
/// folder. Returns one message for each wrong one: "server/solver/a.cpp:12: ...".
std::vector<std::string> check_includes(const std::filesystem::path& root,
                                        const std::vector<std::string>& folders,
                                        const Layers& layers);

/// Checks every link of the CMake targets in `list`, in the form of write_targets.cmake. Returns
/// one message for each wrong one: "target burnish_grid links burnish_session: ...".
std::vector<std::string> check_targets(const std::filesystem::path& list, const Layers& layers);

/// The units (files without their extension) below root/server/solver/cpu and cuda. One message for
/// each that has no twin in the other folder and does not stand in `list`, and for each line of
/// `list` that names nothing or a unit that has a twin.
std::vector<std::string> check_twins(const std::filesystem::path& root,
                                     const std::filesystem::path& list);

}  // namespace burnish
