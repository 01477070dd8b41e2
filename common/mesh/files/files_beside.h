#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/base/file_budget.h"
#include "common/base/status.h"

namespace burnish {

/// The files that a mesh file may name: those of its archive, or of its folder. Paths have '/'
/// between their parts and are relative to one root.
class FilesBeside {
 public:
  virtual ~FilesBeside() = default;

  /// Returns the path of the file that a text in `folder` calls `name`; nothing if it is missing.
  /// A name may have '\' between its parts. A path that leads elsewhere, as other machines' do,
  /// counts by its last part alone.
  std::optional<std::string> find(std::string_view folder, std::string_view name) const;

  /// Needs: a path that find() gave. Fails: as the file cannot be read.
  virtual Result<std::vector<uint8_t>> read(const std::string& path) const = 0;

 private:
  /// Returns the path as it is written there, if there is such a file.
  virtual std::optional<std::string> locate(const std::string& path) const = 0;
};

/// The files beside a mesh file, and its own path among them.
struct MeshSurroundings {
  const FilesBeside* files = nullptr;  ///< null: there are none
  std::string path = {};
  FileBudget budget = {};
};

/// Returns the part of a path before its last '/'; empty if there is none.
std::string folder_of(std::string_view path);

}  // namespace burnish
