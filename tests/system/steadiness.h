#pragma once

#include <map>
#include <string>
#include <vector>

namespace burnish {

/// Counts of live objects, by kind.
using LiveCounts = std::map<std::string, double>;

/// Returns burnish_live_objects of an answer to "GET /metrics".
LiveCounts live_counts(const std::string& metrics);

/// Returns "stream: 3, was 0" for each kind whose count has changed.
std::vector<std::string> not_returned(const LiveCounts& before, const LiveCounts& after);

/// Returns the growth per step of a value read at even steps: the least-squares slope over the
/// second half; the first half is for warming up. Needs: at least four values.
double growth_per_step(const std::vector<double>& values);

}  // namespace burnish
