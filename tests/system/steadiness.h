#pragma once

#include <map>
#include <string>
#include <vector>

namespace burnish {

/// Counts of live objects, by kind.
using LiveCounts = std::map<std::string, double>;

/// What burnish_live_objects says in an answer to "GET /metrics".
LiveCounts live_counts(const std::string& metrics);

/// "stream: 3, was 0" for each kind whose count is not what it was.
std::vector<std::string> not_returned(const LiveCounts& before, const LiveCounts& after);

/// How much a value that is read at even steps grows from one to the next: the least-squares slope
/// over the second half, as the first is for warming up. Needs: four values or more.
double growth_per_step(const std::vector<double>& values);

}  // namespace burnish
