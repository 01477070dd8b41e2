#include "server/metrics/prometheus/exporter.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "server/metrics/live_objects.h"
#include "tests/server/metrics/http_get.h"

namespace burnish {
namespace {

using testing::HasSubstr;

TEST(MetricsExporter, ServesWhatWasCountedAndWhatThereIs) {
  const auto exporter = MetricsExporter::start("127.0.0.1:0", [] {
    return std::vector<Gauge>{{"rooms", "Rooms", 3}, {"doors", "Doors", 2, "kind", "front"}};
  });
  ASSERT_TRUE(exporter.is_ok()) << exporter.status().message();
  set_metrics(exporter.value()->figures());
  metrics().count_call({"/a.B/C", "OK", 0.25, 100, 20});
  metrics().count_call({"/a.B/C", "OK", 0.25, 100, 20});
  metrics().count_refusal(Refusal::kPermission);
  metrics().observe(Measure::kJournalCommitSeconds, 0.003);
  const std::string text = http_get_metrics(exporter.value()->port());
  set_metrics(nullptr);
  EXPECT_EQ(metric(text, "burnish_rpcs_total{code=\"OK\",method=\"/a.B/C\"}"), 2);
  EXPECT_EQ(metric(text, "burnish_rpc_seconds_sum{method=\"/a.B/C\"}"), 0.5);
  EXPECT_EQ(metric(text, "burnish_rpc_received_bytes_total{method=\"/a.B/C\"}"), 200);
  EXPECT_EQ(metric(text, "burnish_rpc_sent_bytes_total{method=\"/a.B/C\"}"), 40);
  EXPECT_EQ(metric(text, "burnish_refusals_total{reason=\"permission\"}"), 1);
  EXPECT_EQ(metric(text, "burnish_refusals_total{reason=\"handshake\"}"), 0);
  EXPECT_EQ(metric(text, "burnish_journal_commit_seconds_count"), 1);
  EXPECT_EQ(metric(text, "rooms"), 3);
  EXPECT_EQ(metric(text, "doors{kind=\"front\"}"), 2);
}

TEST(MetricsExporter, AnAddressInUseIsRefusedByName) {
  const auto nothing = [] { return std::vector<Gauge>(); };
  const auto first = MetricsExporter::start("127.0.0.1:0", nothing);
  ASSERT_TRUE(first.is_ok());
  const std::string address = "127.0.0.1:" + std::to_string(first.value()->port());
  const auto second = MetricsExporter::start(address, nothing);
  EXPECT_EQ(second.status().code(), StatusCode::kUnavailable);
  EXPECT_THAT(second.status().message(), HasSubstr(address));
}

TEST(LiveObject, IsCountedWhileItLives) {
  const int64_t before = live_count(LiveKind::kExport);
  {
    const LiveObject first(LiveKind::kExport), second(LiveKind::kExport);
    EXPECT_EQ(live_count(LiveKind::kExport), before + 2);
  }
  EXPECT_EQ(live_count(LiveKind::kExport), before);
}

}  // namespace
}  // namespace burnish
