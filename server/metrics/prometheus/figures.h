#pragma once

#include <map>
#include <memory>

#include <prometheus/counter.h>
#include <prometheus/histogram.h>
#include <prometheus/registry.h>

#include "server/metrics/metrics.h"

namespace burnish {

/// Keeps the figures in a Prometheus registry: RPCs by method and code, their seconds and bytes by
/// method, refusals by reason, a histogram for each measure.
class PrometheusFigures final : public Metrics {
 public:
  explicit PrometheusFigures(prometheus::Registry& registry);

  void count_call(const CallRecord& call) override;
  void count_refusal(Refusal reason) override;
  void add(Count what, uint64_t number) override;
  void observe(Measure what, double value) override;

 private:
  prometheus::Family<prometheus::Counter>& calls_;
  prometheus::Family<prometheus::Histogram>& call_seconds_;
  prometheus::Family<prometheus::Counter>& bytes_received_;
  prometheus::Family<prometheus::Counter>& bytes_sent_;
  std::map<Refusal, prometheus::Counter*> refusals_;
  std::map<Count, prometheus::Counter*> counts_;
  std::map<Measure, prometheus::Histogram*> measures_;
};

}  // namespace burnish
