#include "tests/layering/layers.h"

#include <fstream>
#include <sstream>

namespace burnish {
namespace {

bool is_below(const std::string& path, const std::string& layer) {
  if (!path.starts_with(layer)) return false;
  return path.size() == layer.size() || path[layer.size()] == '/' || path[layer.size()] == '.';
}

Status add_line(const std::string& line, Layers& layers) {
  std::istringstream words(line);
  std::string kind, name, colon, other;
  words >> kind >> name >> colon;
  if ((kind != "layer" && kind != "only") || colon != ":")
    return invalid_argument("expected 'layer PATH : ...' or 'only PREFIX : ...'");
  std::set<std::string> others;
  while (words >> other) {
    if (kind == "layer" && !layers.allowed.contains(other))
      return invalid_argument(name + " names " + other + ", which does not stand above it");
    others.insert(other);
  }
  (kind == "layer" ? layers.allowed : layers.only)[name] = std::move(others);
  return Status::ok();
}

}  // namespace

std::optional<std::string> Layers::layer_of(const std::string& path) const {
  std::optional<std::string> longest;
  for (const auto& [layer, others] : allowed)
    if (is_below(path, layer) && (!longest || layer.size() > longest->size())) longest = layer;
  return longest;
}

std::string Layers::objection(const std::string& layer, const std::string& name) const {
  for (const auto& [prefix, users] : only) {
    if (!name.starts_with(prefix) || users.contains(layer)) continue;
    return name + " is only for other folders than " + layer;
  }
  const auto other = layer_of(name);
  if (!other || *other == layer || allowed.at(layer).contains(*other)) return {};
  return layer + " may not depend on " + *other;
}

Result<Layers> read_layers(const std::filesystem::path& table) {
  std::ifstream file(table);
  if (!file) return not_found(table.string() + ": cannot be read");
  Layers layers;
  std::string line;
  for (int number = 1; std::getline(file, line); ++number) {
    if (line.empty() || line.front() == '#') continue;
    RETURN_IF_ERROR(
        add_line(line, layers).with_context(table.string() + ":" + std::to_string(number)));
  }
  return layers;
}

}  // namespace burnish
