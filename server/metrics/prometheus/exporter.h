#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "common/base/status.h"
#include "server/metrics/metrics.h"

namespace burnish {

/// A figure that is read on request.
struct Gauge {
  std::string name;
  std::string help;
  double value = 0;
  std::string label = {};  ///< empty for none
  std::string label_value = {};
};

/// Serves the figures over HTTP at /metrics, in Prometheus' text format.
class MetricsExporter {
 public:
  /// Listens on HOST:PORT; port 0 takes a free port. A thread of the exporter calls `gauges` for
  /// every scrape. Fails: unavailable if the address cannot be bound.
  static Result<std::unique_ptr<MetricsExporter>> start(const std::string& listen,
                                                        std::function<std::vector<Gauge>()> gauges);
  ~MetricsExporter();

  /// The sink behind the counters and histograms. It outlives the exporter: threads may still
  /// count.
  std::shared_ptr<Metrics> figures() const;

  int port() const;

 private:
  struct State;
  explicit MetricsExporter(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace burnish
