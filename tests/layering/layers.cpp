#include "tests/layering/layers.h"

#include <fstream>
#include <sstream>

namespace burnish {
namespace {

bool is_below(const std::string& path, const std::string& layer) {
  if (!path.starts_with(layer)) return false;
  return path.size() == layer.size() || path[layer.size()] == '/' || path[layer.size()] == '.';
}

std::string folder_of(const std::string& path) {
  return path.substr(0, path.rfind('/'));
}

// A part names what lies beside it alone, and only that names a part.
bool may_name(const std::string& name, const std::string& other, const Layers& layers) {
  if (!layers.parts.contains(name) && !layers.parts.contains(other)) return true;
  return layers.whole_of(name) == layers.whole_of(other);
}

Status add_line(const std::string& line, Layers& layers) {
  std::istringstream words(line);
  std::string kind, name, colon, other;
  words >> kind >> name >> colon;
  if ((kind != "layer" && kind != "part" && kind != "only") || colon != ":")
    return invalid_argument(
        "expected 'layer PATH : ...', 'part PATH : ...' or 'only PREFIX : ...'");
  if (kind == "part") layers.parts.insert(name);
  std::set<std::string> others;
  while (words >> other) {
    if (kind != "only" && !layers.allowed.contains(other))
      return invalid_argument(name + " names " + other + ", which does not stand above it");
    if (kind != "only" && !may_name(name, other, layers))
      return invalid_argument(name + " names " + other + ", but one is a part of another layer");
    others.insert(other);
  }
  (kind == "only" ? layers.only : layers.allowed)[name] = std::move(others);
  return Status::ok();
}

Status check_parts(const Layers& layers) {
  for (const std::string& part : layers.parts)
    if (layers.parts.contains(folder_of(part)) || !layers.allowed.contains(folder_of(part)))
      return invalid_argument("part " + part + ": " + folder_of(part) + " is not a layer");
  return Status::ok();
}

}  // namespace

std::optional<std::string> Layers::layer_of(const std::string& path) const {
  std::optional<std::string> longest;
  for (const auto& [layer, others] : allowed)
    if (is_below(path, layer) && (!longest || layer.size() > longest->size())) longest = layer;
  return longest;
}

std::string Layers::whole_of(const std::string& layer) const {
  return parts.contains(layer) ? folder_of(layer) : layer;
}

std::string Layers::objection(const std::string& layer, const std::string& name) const {
  const std::string whole = whole_of(layer);
  for (const auto& [prefix, users] : only) {
    if (!name.starts_with(prefix) || users.contains(layer) || users.contains(whole)) continue;
    return name + " is only for other folders than " + layer;
  }
  const auto other = layer_of(name);
  if (!other || *other == layer || allowed.at(layer).contains(*other)) return {};
  // Two parts of a layer name each other. All else is as with their layers.
  const std::string other_whole = whole_of(*other);
  if (other_whole != whole && allowed.at(whole).contains(other_whole)) return {};
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
  RETURN_IF_ERROR(check_parts(layers).with_context(table.string()));
  return layers;
}

}  // namespace burnish
