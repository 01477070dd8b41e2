#include "common/denoise/denoise_options.h"

#include <string>
#include <vector>

#include "common/base/text.h"

namespace burnish {

static Status outside(const std::string& thing, const std::string& value, double least,
                      double most) {
  return invalid_argument(thing + " " + value + " is outside " + shortest_text(least) + ".." +
                          shortest_text(most));
}

Status validate(const DenoiseOptions& options) {
  if (!(options.sigma >= kSigmaMin && options.sigma <= kSigmaMax))
    return outside("edge angle", shortest_text(options.sigma), kSigmaMin, kSigmaMax);
  if (options.passes < 0 || options.passes > kNormalPassesMax)
    return outside("number of passes", std::to_string(options.passes), 0, kNormalPassesMax);
  if (!(options.crispness >= 0 && options.crispness <= kCrispnessMax))
    return outside("crispness", shortest_text(options.crispness), 0, kCrispnessMax);
  if (!(options.cap >= 0))
    return invalid_argument("cap of the layer " + shortest_text(options.cap) + " is less than 0");
  return Status::ok();
}

DenoiseOptions options_of(const EdgeFilter& filter) {
  return {.kind = filter.kind,
          .sigma = filter.sigma(),
          .passes = filter.passes,
          .crispness = filter.crispness};
}

std::span<const DenoisePreset> denoise_presets() {
  static const std::vector<DenoisePreset> presets = [] {
    std::vector<DenoisePreset> all;
    for (const EdgePreset& preset : edge_presets())
      all.push_back({preset.name, options_of(preset.filter)});
    return all;
  }();
  return presets;
}

}  // namespace burnish
