#include "server/metrics/prometheus/exporter.h"

#include <exception>
#include <utility>

#include <prometheus/exposer.h>

#include "server/metrics/prometheus/figures.h"

namespace burnish {
namespace {

/// Turns the gauges into Prometheus' families; gauges of one name are neighbours.
class GaugeReader final : public prometheus::Collectable {
 public:
  explicit GaugeReader(std::function<std::vector<Gauge>()> gauges) : gauges_(std::move(gauges)) {}

  std::vector<prometheus::MetricFamily> Collect() const override {
    std::vector<prometheus::MetricFamily> families;
    for (const Gauge& gauge : gauges_()) {
      if (families.empty() || families.back().name != gauge.name)
        families.push_back({gauge.name, gauge.help, prometheus::MetricType::Gauge, {}});
      prometheus::ClientMetric metric;
      metric.gauge.value = gauge.value;
      if (!gauge.label.empty()) metric.label.push_back({gauge.label, gauge.label_value});
      families.back().metric.push_back(std::move(metric));
    }
    return families;
  }

 private:
  const std::function<std::vector<Gauge>()> gauges_;
};

}  // namespace

struct MetricsExporter::State {
  std::shared_ptr<prometheus::Registry> registry = std::make_shared<prometheus::Registry>();
  std::shared_ptr<PrometheusFigures> figures = std::make_shared<PrometheusFigures>(*registry);
  std::shared_ptr<GaugeReader> gauges;
  std::unique_ptr<prometheus::Exposer> exposer;  // last member: its threads read the others
};

Result<std::unique_ptr<MetricsExporter>> MetricsExporter::start(
    const std::string& listen, std::function<std::vector<Gauge>()> gauges) try {
  auto state = std::make_unique<State>();
  state->gauges = std::make_shared<GaugeReader>(std::move(gauges));
  state->exposer = std::make_unique<prometheus::Exposer>(listen, 1);
  state->exposer->RegisterCollectable(state->registry);
  state->exposer->RegisterCollectable(state->gauges);
  return std::unique_ptr<MetricsExporter>(new MetricsExporter(std::move(state)));
} catch (const std::exception&) {
  return unavailable("cannot serve metrics on " + listen +
                     ": the address is in use or not of this machine");
}

MetricsExporter::MetricsExporter(std::unique_ptr<State> state) : state_(std::move(state)) {}

MetricsExporter::~MetricsExporter() = default;

std::shared_ptr<Metrics> MetricsExporter::figures() const {
  const auto both = std::make_shared<
      std::pair<std::shared_ptr<prometheus::Registry>, std::shared_ptr<PrometheusFigures>>>(
      state_->registry, state_->figures);
  return std::shared_ptr<Metrics>(both, state_->figures.get());
}

int MetricsExporter::port() const {
  return state_->exposer->GetListeningPorts().front();
}

}  // namespace burnish
