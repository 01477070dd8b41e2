#include <algorithm>
#include <array>
#include <fstream>
#include <regex>

#include "tests/layering/layers.h"

namespace burnish {
namespace {

namespace fs = std::filesystem;

bool is_source(const fs::path& path) {
  static constexpr std::array<const char*, 4> kExtensions = {".h", ".cpp", ".cu", ".cuh"};
  return std::find(kExtensions.begin(), kExtensions.end(), path.extension()) != kExtensions.end();
}

std::vector<std::string> sources_below(const fs::path& root, const std::string& folder) {
  std::vector<std::string> sources;
  for (const auto& entry : fs::recursive_directory_iterator(root / folder))
    if (entry.is_regular_file() && is_source(entry.path()))
      sources.push_back(fs::relative(entry.path(), root).generic_string());
  std::sort(sources.begin(), sources.end());
  return sources;
}

void check_file(const fs::path& root, const std::string& path, const Layers& layers,
                std::vector<std::string>& wrong) {
  static const std::regex include(R"re(^\s*#\s*include\s*["<]([^">]+)[">].*)re");
  const auto layer = layers.layer_of(path);
  if (!layer) {
    wrong.push_back(path + ":1: the file is of no layer; name its folder in layers.txt");
    return;
  }
  std::ifstream file(root / path);
  std::string line;
  for (int number = 1; std::getline(file, line); ++number) {
    std::smatch match;
    if (!std::regex_match(line, match, include)) continue;
    const std::string objection = layers.objection(*layer, match[1]);
    if (!objection.empty()) wrong.push_back(path + ":" + std::to_string(number) + ": " + objection);
  }
}

}  // namespace

std::vector<std::string> check_includes(const fs::path& root,
                                        const std::vector<std::string>& folders,
                                        const Layers& layers) {
  std::vector<std::string> wrong;
  for (const std::string& folder : folders)
    for (const std::string& path : sources_below(root, folder))
      check_file(root, path, layers, wrong);
  return wrong;
}

}  // namespace burnish
