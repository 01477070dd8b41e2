#include "client/cli/bench/load_mix.h"

#include <algorithm>
#include <charconv>
#include <numeric>
#include <sstream>

namespace burnish {

static constexpr std::array<const char*, 3> kNames = {"draw", "drag", "paint"};

Activity LoadMix::choose(std::mt19937& random) const {
  std::discrete_distribution<int> activity(weight.begin(), weight.end());
  return static_cast<Activity>(activity(random));
}

Result<LoadMix> parse_load_mix(const std::string& text) {
  LoadMix mix{{0, 0, 0}};
  std::istringstream parts(text);
  for (std::string part; std::getline(parts, part, ',');) {
    const size_t equals = std::min(part.find('='), part.size());
    const auto name = std::ranges::find(kNames, part.substr(0, equals));
    if (name == kNames.end())
      return invalid_argument("'" + part + "' does not begin with draw=, drag= or paint=");
    double& weight = mix.weight[static_cast<size_t>(name - kNames.begin())];
    const char* end = part.data() + part.size();
    const auto [read, error] =
        std::from_chars(part.data() + std::min(equals + 1, part.size()), end, weight);
    if (error != std::errc() || read != end || !(weight >= 0 && weight <= 1e6))
      return invalid_argument("the weight in '" + part + "' is no number of 0 to 1000000");
  }
  if (std::accumulate(mix.weight.begin(), mix.weight.end(), 0.0) <= 0)
    return invalid_argument("the mix '" + text + "' leaves nothing to do");
  return mix;
}

}  // namespace burnish
