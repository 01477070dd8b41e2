#include "client/cli/bench/load_mix.h"

#include <algorithm>
#include <numeric>
#include <sstream>

#include "common/base/parse_number.h"

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
    const auto weight =
        parse_number<double>(std::string_view(part).substr(std::min(equals + 1, part.size())));
    if (!weight || !(*weight >= 0 && *weight <= 1e6))
      return invalid_argument("the weight in '" + part + "' is not a number in 0..1000000");
    mix.weight[static_cast<size_t>(name - kNames.begin())] = *weight;
  }
  if (std::accumulate(mix.weight.begin(), mix.weight.end(), 0.0) <= 0)
    return invalid_argument("the mix '" + text + "' has only weights of 0");
  return mix;
}

}  // namespace burnish
