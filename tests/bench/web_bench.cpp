// Measures the web gateway: the round trip of short calls that follow each other on one socket, and
// the throughput of an export; in plain text and with TLS.
//
//   web_bench [VERTICES [FILE]]
//
// Exports a generated blob of 1,000,000 vertices, or VERTICES. Writes its figures to FILE,
// web_bench.json for tests/bench/write_tables. The client is Beast's, in this process. Both ends
// share the machine. The export is prepared once before: the time is that of its bytes.

#include <cstdio>
#include <fstream>

#include <nlohmann/json.hpp>

#include "burnish/v1/editing.pb.h"
#include "common/generate/generate.h"
#include "common/mesh/io/mesh_io.h"
#include "tests/bench/timing.h"
#include "tests/server/trust/test_certificates.h"
#include "tests/system/web_client.h"

namespace burnish {
namespace {

constexpr int kCalls = 2000, kCallsToWarmUp = 200;
constexpr int kExports = 3;

struct WebFigures {
  double p50_ms, p95_ms, megabytes_per_s;
};

std::string export_request() {
  v1::ExportRequest request;
  request.set_session("work");
  request.set_format(v1::MESH_FORMAT_PLY);
  request.set_cycles(1);
  return request.SerializeAsString();
}

/// Returns the bytes after the first chunk, and their seconds.
std::pair<double, double> timed_export(WebClient& client) {
  client.send_text(begin_of(kExportRpc));
  client.send_message(export_request());
  client.send_text(R"({"end":true})");
  double bytes = 0;
  std::optional<std::chrono::steady_clock::time_point> begin;
  v1::ExportEvent event;
  while (const auto frame = client.read()) {
    if (frame->is_text) break;
    if (begin) {
      bytes += static_cast<double>(frame->bytes.size());
    } else if (event.ParseFromString(frame->bytes) && event.has_chunk()) {
      begin = std::chrono::steady_clock::now();
    }
  }
  BURNISH_CHECK(begin && bytes > 0, "the export has no bytes");
  return {bytes, std::chrono::duration<double>(std::chrono::steady_clock::now() - *begin).count()};
}

WebFigures measure(const std::string& address, const std::string& ca) {
  WebClient client(address, {.ca = ca});
  BURNISH_CHECK(client.is_open(), "the gateway does not open");
  std::vector<double> times;
  for (int i = 0; i < kCalls + kCallsToWarmUp; ++i) {
    const double ms = milliseconds([&] {
      BURNISH_CHECK(call(client, {kListScansRpc, {""}}).status.ok(), "a call failed");
    });
    if (i >= kCallsToWarmUp) times.push_back(ms);
  }
  std::ranges::sort(times);
  WebFigures figures{times[times.size() / 2], times[times.size() * 95 / 100], 0};
  for (int i = 0; i < kExports; ++i) {
    const auto [bytes, seconds] = timed_export(client);
    figures.megabytes_per_s = std::max(figures.megabytes_per_s, bytes / seconds * 1e-6);
  }
  return figures;
}

nlohmann::ordered_json run_gateway(const char* name, std::vector<std::string> flags,
                                   const std::string& ca, const std::string& scan) {
  flags.insert(flags.end(), {"--web", "127.0.0.1:0", "--socket"});
  const TemporaryFolder folder;
  flags.push_back((folder / "s").string());
  ServerProcess server(flags);
  server.address = "unix:" + (folder / "s").string();
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"import", scan, "--name", "ball", "--depth", "7"},
        std::vector<std::string>{"open", "ball", "--depth", "7", "--session", "work"}}) {
    const CommandOutcome outcome = server.burnish(words);
    BURNISH_CHECK(outcome.exit_code == 0, outcome.output);
  }
  const WebFigures figures = measure(web_address(server), ca);
  std::printf("%-6s %8.2f %8.2f %8.0f\n", name, figures.p50_ms, figures.p95_ms,
              figures.megabytes_per_s);
  std::fflush(stdout);
  return {{"gateway", name},
          {"call_p50_ms", figures.p50_ms},
          {"call_p95_ms", figures.p95_ms},
          {"export_mb_per_s", figures.megabytes_per_s}};
}

int main_of(int argc, char** argv) {
  const TemporaryFolder folder;
  const uint64_t vertices = argc > 1 ? std::stoull(argv[1]) : 1'000'000;
  const auto scan = folder / "blob.ply";
  const Status written =
      write_mesh(generate_scan({.kind = "blob", .vertices = vertices}).value(), scan);
  BURNISH_CHECK(written.is_ok(), written.message());
  const TestCa ca("a CA for the bench");
  const TestCa::Issued issued = ca.issue("server");
  const std::string certificate = folder.write("server.pem", issued.certificate).string();
  const auto key = folder.write("server.key", issued.key);
  std::filesystem::permissions(key, std::filesystem::perms(0600));

  std::printf("%-6s %8s %8s %8s\n", "gateway", "p50, ms", "p95, ms", "MB/s");
  const nlohmann::ordered_json rows = {
      run_gateway("plain", {}, "", scan.string()),
      run_gateway("TLS", {"--tls-certificate", certificate, "--tls-key", key.string()},
                  ca.certificate(), scan.string())};
  if (argc > 2) std::ofstream(argv[2]) << rows.dump(1) << "\n";
  return 0;
}

}  // namespace
}  // namespace burnish

int main(int argc, char** argv) {
  return burnish::main_of(argc, argv);
}
