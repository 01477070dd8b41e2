#include <algorithm>
#include <fstream>

#include "tests/layering/layers.h"

namespace burnish {
namespace {

struct Target {
  std::set<std::string> layers;  // of its sources
  std::set<std::string> links;
};

std::map<std::string, Target> read_targets(const std::filesystem::path& path,
                                           const Layers& layers) {
  std::map<std::string, Target> targets;
  std::ifstream file(path);
  std::string kind, name, value;
  while (file >> kind >> name >> value) {
    if (kind == "link") {
      targets[name].links.insert(value);
    } else if (const auto layer = layers.layer_of(value)) {
      targets[name].layers.insert(*layer);
    }
  }
  return targets;
}

// A target may link another if one of its sources may include one of the other's.
std::string objection(const Target& target, const std::set<std::string>& others,
                      const Layers& layers) {
  std::string last;
  for (const std::string& layer : target.layers)
    for (const std::string& other : others) {
      last = layers.objection(layer, other);
      if (last.empty()) return {};
    }
  return last;
}

}  // namespace

std::vector<std::string> check_targets(const std::filesystem::path& list, const Layers& layers) {
  const auto targets = read_targets(list, layers);
  std::vector<std::string> wrong;
  for (const auto& [name, target] : targets) {
    for (const std::string& link : target.links) {
      const auto other = targets.find(link);
      const std::set<std::string> used =
          other == targets.end() ? std::set{link} : other->second.layers;
      const std::string why = objection(target, used, layers);
      if (!why.empty()) wrong.push_back("target " + name + " links " + link + ": " + why);
    }
  }
  return wrong;
}

}  // namespace burnish
