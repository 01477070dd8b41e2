#include "common/edit/edge_filter.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "common/edit/check_between.h"

namespace burnish {

double EdgeFilter::sigma() const {
  return std::sin(edge_angle / 2 * std::numbers::pi / 180);
}

std::string_view name_of(NormalFilterKind kind) {
  return kind == NormalFilterKind::kEdges ? "edges" : "bilateral";
}

std::span<const EdgePreset> edge_presets() {
  using enum NormalFilterKind;
  static constexpr EdgePreset kPresets[] = {
      {"machined",
       "Machined part",
       "parts with sharp edges and flat faces",
       {1, kEdges, 35, 10, 1}},
      {"scanner",
       "Scanner noise, keep edges",
       "scanner noise on any shape; edges stay",
       {1, kBilateral, 35, 20, 1}},
      {"soft", "Soft surface", "rounded shapes", {1, kBilateral, 53, 5, 1}},
      {"relief", "Relief and inscription", "reliefs and inscriptions", {1, kBilateral, 35, 5, 0}},
  };
  return kPresets;
}

Result<EdgePreset> find_edge_preset(std::string_view name) {
  std::string names;
  for (const EdgePreset& preset : edge_presets()) {
    if (preset.name == name) return preset;
    names += (names.empty() ? "" : ", ") + std::string(preset.name);
  }
  return invalid_argument("'" + std::string(name) + "' keeps no edges; there are " + names);
}

const EdgePreset* preset_of(const EdgeFilter& filter) {
  for (const EdgePreset& preset : edge_presets()) {
    EdgeFilter whole = filter;
    whole.strength = preset.filter.strength;
    if (whole == preset.filter) return &preset;
  }
  return nullptr;
}

double noise_size(int passes, double mean_edge) {
  return mean_edge * std::sqrt(passes);
}

int passes_of_noise_size(double size, double mean_edge) {
  const double edges = size / mean_edge;
  return std::clamp(static_cast<int>(std::lround(edges * edges)), 1, kNormalPassesMax);
}

Result<NormalFilterKind> parse_normal_filter(std::string_view word) {
  for (const auto kind : {NormalFilterKind::kBilateral, NormalFilterKind::kEdges})
    if (word == name_of(kind)) return kind;
  return invalid_argument("filter of normals '" + std::string(word) +
                          "' is not bilateral or edges");
}

std::string text_of(const EdgeFilter& filter) {
  if (!filter.is_on()) return "edges not kept";
  char text[120];
  std::snprintf(text, sizeof text, "edges kept at strength %g, angle %g, %d %s, crispness %g%s",
                filter.strength, filter.edge_angle, filter.passes,
                filter.passes == 1 ? "pass" : "passes", filter.crispness,
                filter.kind == NormalFilterKind::kEdges ? ", machined" : "");
  return text;
}

Status check_edge_filter(const EdgeFilter& filter) {
  RETURN_IF_ERROR(check_between("edges: strength", filter.strength, 0, 1));
  RETURN_IF_ERROR(check_between("edges: angle", filter.edge_angle, kEdgeAngleMin, kEdgeAngleMax));
  RETURN_IF_ERROR(check_between("edges: passes", filter.passes, 1, kNormalPassesMax));
  return check_between("edges: crispness", filter.crispness, 0, 1);
}

}  // namespace burnish
