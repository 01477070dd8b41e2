#include "server/metrics/prometheus/figures.h"

namespace burnish {

using prometheus::Counter;
using prometheus::Histogram;

namespace {

Histogram::BucketBoundaries decades(double first, double last) {
  Histogram::BucketBoundaries bounds;
  for (double decade = first; decade < last * 1.5; decade *= 10)
    for (const double step : {1.0, 2.0, 5.0}) bounds.push_back(decade * step);
  return bounds;
}

const Histogram::BucketBoundaries& seconds() {
  static const Histogram::BucketBoundaries bounds = decades(1e-4, 100);
  return bounds;
}

struct RefusalName {
  Refusal reason;
  const char* name;
};

constexpr RefusalName kRefusals[] = {
    {Refusal::kUnauthenticated, "unauthenticated"},
    {Refusal::kPermission, "permission"},
    {Refusal::kUnknownRpc, "unknown_rpc"},
    {Refusal::kLimit, "limit"},
    {Refusal::kDraining, "draining"},
    {Refusal::kMalformed, "malformed"},
    {Refusal::kCutOff, "cut_off"},
    {Refusal::kConnections, "connections"},
    {Refusal::kHandshake, "handshake"},
    {Refusal::kHost, "host"},
    {Refusal::kKeptSessions, "kept_sessions"},
    {Refusal::kHistory, "history"},
    {Refusal::kOrigin, "origin"},
};

prometheus::Family<Counter>& counters(prometheus::Registry& registry, const char* name,
                                      const char* help) {
  return prometheus::BuildCounter().Name(name).Help(help).Register(registry);
}

prometheus::Family<Histogram>& histograms(prometheus::Registry& registry, const char* name,
                                          const char* help) {
  return prometheus::BuildHistogram().Name(name).Help(help).Register(registry);
}

}  // namespace

PrometheusFigures::PrometheusFigures(prometheus::Registry& registry)
    : calls_(counters(registry, "burnish_rpcs_total", "RPCs that have ended, by method and code")),
      call_seconds_(histograms(registry, "burnish_rpc_seconds", "Duration of RPCs by method")),
      bytes_received_(counters(registry, "burnish_rpc_received_bytes_total",
                               "Bytes of the messages that clients sent, by method")),
      bytes_sent_(counters(registry, "burnish_rpc_sent_bytes_total",
                           "Bytes of the messages that were sent to clients, by method")) {
  auto& refusals = counters(registry, "burnish_refusals_total", "Refusals by reason");
  for (const RefusalName& refusal : kRefusals)
    refusals_[refusal.reason] = &refusals.Add({{"reason", refusal.name}});
  const auto count = [&](Count what, const char* name, const char* help) {
    counts_[what] = &counters(registry, name, help).Add({});
  };
  count(Count::kWebSockets, "burnish_web_sockets_total", "WebSockets that were opened");
  count(Count::kWebCalls, "burnish_web_rpcs_total", "RPCs that WebSockets carried");
  count(Count::kWebReceivedBytes, "burnish_web_received_bytes_total",
        "Bytes of the frames that WebSockets received");
  count(Count::kWebSentBytes, "burnish_web_sent_bytes_total",
        "Bytes of the frames that WebSockets sent");
  count(Count::kSessionsClaimed, "burnish_fleet_claims_total",
        "Sessions of a fleet that this server has taken");
  count(Count::kFencedAppends, "burnish_fleet_fenced_appends_total",
        "Appends to sessions that another server had taken");
  count(Count::kFallBacks, "burnish_solver_fall_backs_total",
        "Steps of solvers that were not sound: a plainer smoother went on");
  count(Count::kCallsMoved, "burnish_fleet_moved_total",
        "Calls that were sent to the server that has their session");
  const auto measure = [&](Measure what, const char* name, const char* help, const auto& bounds) {
    measures_[what] = &histograms(registry, name, help).Add({}, bounds);
  };
  measure(Measure::kJournalCommitSeconds, "burnish_journal_commit_seconds",
          "Time until a commit of the journal was on disk", seconds());
  measure(Measure::kDatabaseRoundTripSeconds, "burnish_database_round_trip_seconds",
          "Time until the fleet's database had answered a heartbeat", seconds());
  measure(Measure::kAssembleSeconds, "burnish_solver_assemble_seconds",
          "Matrices and constraint of one solve", seconds());
  measure(Measure::kSolveSeconds, "burnish_solver_solve_seconds", "Cycles of one solve", seconds());
  measure(Measure::kResidual, "burnish_solver_residual", "Relative residual at the end of a solve",
          decades(1e-12, 1));
  measure(Measure::kFrameAssembleSeconds, "burnish_frame_assemble_seconds",
          "Matrices and constraint of one turn of a live session", seconds());
  measure(Measure::kFrameSolveSeconds, "burnish_frame_solve_seconds", "One cycle of a live session",
          seconds());
  measure(Measure::kFrameEncodeSeconds, "burnish_frame_encode_seconds",
          "Encoding of one client's frame", seconds());
  measure(Measure::kFrameBytes, "burnish_frame_bytes", "Bytes of the frames that were made",
          decades(100, 1e7));
}

void PrometheusFigures::count_call(const CallRecord& call) {
  const std::string method(call.method);
  calls_.Add({{"method", method}, {"code", std::string(call.code)}}).Increment();
  call_seconds_.Add({{"method", method}}, seconds()).Observe(call.seconds);
  bytes_received_.Add({{"method", method}}).Increment(static_cast<double>(call.bytes_received));
  bytes_sent_.Add({{"method", method}}).Increment(static_cast<double>(call.bytes_sent));
}

void PrometheusFigures::count_refusal(Refusal reason) {
  refusals_.at(reason)->Increment();
}

void PrometheusFigures::add(Count what, uint64_t number) {
  counts_.at(what)->Increment(static_cast<double>(number));
}

void PrometheusFigures::observe(Measure what, double value) {
  measures_.at(what)->Observe(value);
}

}  // namespace burnish
