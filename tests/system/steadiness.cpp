#include "tests/system/steadiness.h"

#include <sstream>

#include "server/metrics/live_objects.h"
#include "tests/server/metrics/http_get.h"

namespace burnish {

LiveCounts live_counts(const std::string& metrics) {
  LiveCounts counts;
  for (const LiveKind kind : kLiveKinds) {
    const std::string name(live_kind_name(kind));
    counts[name] = metric(metrics, "burnish_live_objects{kind=\"" + name + "\"}");
  }
  return counts;
}

std::vector<std::string> not_returned(const LiveCounts& before, const LiveCounts& after) {
  std::vector<std::string> found;
  for (const auto& [kind, was] : before) {
    const double is = after.at(kind);
    if (is == was) continue;
    std::ostringstream line;
    line << kind << ": " << is << ", was " << was;
    found.push_back(line.str());
  }
  return found;
}

double growth_per_step(const std::vector<double>& values) {
  const size_t begin = values.size() / 2;
  const double count = static_cast<double>(values.size() - begin);
  const double middle = (count - 1) / 2;
  double product = 0, square = 0;
  for (size_t i = begin; i < values.size(); ++i) {
    const double step = static_cast<double>(i - begin) - middle;
    product += step * values[i];
    square += step * step;
  }
  return product / square;
}

}  // namespace burnish
