#include "common/denoise/denoise_options.h"

#include <string>

#include "common/base/text.h"

namespace burnish {

static Status outside(const std::string& thing, const std::string& value, double least,
                      double most) {
  return invalid_argument(thing + " " + value + " is outside " + shortest_text(least) + ".." +
                          shortest_text(most));
}

Status validate(const DenoiseOptions& options) {
  if (!(options.sigma >= kEdgeAngleMin && options.sigma <= kEdgeAngleMax))
    return outside("edge angle", shortest_text(options.sigma), kEdgeAngleMin, kEdgeAngleMax);
  if (options.passes < 0 || options.passes > kFilterPassesMax)
    return outside("number of passes", std::to_string(options.passes), 0, kFilterPassesMax);
  if (!(options.crispness >= 0 && options.crispness <= kCrispnessMax))
    return outside("crispness", shortest_text(options.crispness), 0, kCrispnessMax);
  if (!(options.cap >= 0))
    return invalid_argument("cap of the layer " + shortest_text(options.cap) + " is less than 0");
  return Status::ok();
}

Result<NormalFilterKind> parse_normal_filter(std::string_view word) {
  for (const auto kind : {NormalFilterKind::kBilateral, NormalFilterKind::kEdges})
    if (word == name_of(kind)) return kind;
  return invalid_argument("filter of normals '" + std::string(word) +
                          "' is not bilateral or edges");
}

std::string_view name_of(NormalFilterKind kind) {
  return kind == NormalFilterKind::kEdges ? "edges" : "bilateral";
}

std::span<const DenoisePreset> denoise_presets() {
  using enum NormalFilterKind;
  static constexpr DenoisePreset kPresets[] = {
      {"Machined part", {.kind = kEdges, .sigma = 0.3, .passes = 10, .crispness = 1}},
      {"Scanner noise, keep edges",
       {.kind = kBilateral, .sigma = 0.3, .passes = 20, .crispness = 1}},
      {"Soft surface", {.kind = kBilateral, .sigma = 0.45, .passes = 5, .crispness = 1}},
      {"Relief and inscriptions", {.kind = kBilateral, .sigma = 0.3, .passes = 5, .crispness = 0}},
  };
  return kPresets;
}

}  // namespace burnish
