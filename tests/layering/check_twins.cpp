#include <fstream>

#include "tests/layering/layers.h"

namespace burnish {
namespace {

namespace fs = std::filesystem;

// Paths below `folder`, without their extensions.
std::set<std::string> units_below(const fs::path& folder) {
  std::set<std::string> units;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file())
      units.insert(fs::relative(entry.path(), folder).replace_extension().generic_string());
  return units;
}

std::set<std::string> listed_paths(const fs::path& list) {
  std::set<std::string> paths;
  std::ifstream file(list);
  std::string line;
  while (std::getline(file, line))
    if (!line.empty() && line.front() != '#') paths.insert(line.substr(0, line.find(" : ")));
  return paths;
}

// A listed path that ends with / stands for all below it.
bool covers(const std::string& listed, const std::string& path) {
  return listed == path || (listed.ends_with('/') && path.starts_with(listed));
}

}  // namespace

std::vector<std::string> check_twins(const fs::path& root, const fs::path& list) {
  const fs::path solver = root / "server/solver";
  const auto cpu = units_below(solver / "cpu"), cuda = units_below(solver / "cuda");
  std::set<std::string> alone;
  for (const std::string& unit : cpu)
    if (!cuda.contains(unit)) alone.insert("cpu/" + unit);
  for (const std::string& unit : cuda)
    if (!cpu.contains(unit)) alone.insert("cuda/" + unit);

  std::vector<std::string> wrong;
  std::set<std::string> unused = listed_paths(list);
  const auto listed = unused;
  for (const std::string& path : alone) {
    bool is_listed = false;
    for (const std::string& other : listed) {
      if (!covers(other, path)) continue;
      is_listed = true;
      unused.erase(other);
    }
    if (!is_listed) wrong.push_back("server/solver/" + path + " has no twin");
  }
  for (const std::string& path : unused)
    wrong.push_back(list.filename().string() + " lists " + path + ", which is not alone");
  return wrong;
}

}  // namespace burnish
