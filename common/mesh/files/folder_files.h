#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "common/mesh/files/files_beside.h"

namespace burnish {

/// The files in a folder and below it. A name may differ in capital letters, if no other does. A
/// link that leads out of the folder is not followed.
class FolderFiles final : public FilesBeside {
 public:
  explicit FolderFiles(const std::filesystem::path& folder);

  Result<std::vector<uint8_t>> read(const std::string& path) const override;

 private:
  std::optional<std::string> locate(const std::string& path) const override;

  std::filesystem::path folder_;
};

}  // namespace burnish
