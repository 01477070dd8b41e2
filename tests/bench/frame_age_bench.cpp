// Measures how old frames are when a client has them, and the cost of a stopped client to the
// server.
//
//   frame_age_bench [SCAN [DEPTH [PAGES [FILE]]]]
//
// Without a scan it takes a generated blob of 100,000 vertices. Readers show the coarsest pages of
// the scan: kLoadPages, or PAGES; 0 stands for all. Adds its figures to FILE, frame_age_bench.json
// for tests/bench/write_tables.
//
// One person drags the slider without a pause, over links of several kinds. A frame's age comes
// from the newest heartbeat that the server had when it made the frame, less half a round trip.
// Heartbeats go out every 2 ms, so ages may be too high by that much. Mbit/s is the link's whole
// traffic, else that of frames.

#include <csignal>
#include <cstdio>
#include <fstream>
#include <thread>

#include "client/cli/bench/load_client.h"
#include "client/cli/bench/load_report.h"
#include "client/cli/bench/load_surface.h"
#include "common/generate/generate.h"
#include "common/mesh/io/mesh_io.h"
#include "tests/system/link.h"
#include "tests/system/server_process.h"

namespace burnish {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr double kSecondsPerCase = 8;
constexpr size_t kPagesOfADownload = 500;
constexpr double kBarMs = 20;  // beyond the round trip

struct Case {
  const char* name;
  double pictures_per_second;
  double megabits_per_second;  // 0 without a link
  double rtt_ms;
  int readers = 1;        // over one link; the first one drags
  bool download = false;  // somebody fetches pages through the same link again and again
};
constexpr Case kCases[] = {
    {"10 Hz reader", 10, 0, 0},
    {"60 Hz reader", 60, 0, 0},
    {"10 Hz, 50 Mbit/s, 40 ms", 10, 50, 40},
    {"60 Hz, 50 Mbit/s, 40 ms", 60, 50, 40},
    {"4 of 60 Hz, 50 Mbit/s, 40 ms", 60, 50, 40, 4},
    {"60 Hz beside a download", 60, 50, 40, 1, true},
    {"60 Hz, 10 Mbit/s, 40 ms", 60, 10, 40},
};

void must(const Status& status) {
  BURNISH_CHECK(status.is_ok(), status.message());
}

/// Fetches pages through the link until the bench ends, if `download` asks for it.
class Download {
 public:
  Download(const std::string& server, bool wanted) {
    if (wanted) thread_ = std::thread([this, server] { run(server); });
  }
  ~Download() {
    stopping_ = true;
    if (thread_.joinable()) thread_.join();
  }

 private:
  void run(const std::string& server) {
    Connection connection = Connection::open(server, kPatience).value();
    while (!stopping_) (void)fetch_load_surface(connection, "work", kPagesOfADownload);
  }

  std::atomic<bool> stopping_{false};
  std::thread thread_;
};

nlohmann::ordered_json run_case(const ServerProcess& server,
                                const std::shared_ptr<const LoadSurface>& surface, const Case& c) {
  std::optional<Link> link;
  if (c.megabits_per_second > 0)
    link.emplace(
        server.address,
        LinkOptions{.megabits_per_second = c.megabits_per_second,
                    .delay = std::chrono::microseconds(static_cast<int64_t>(c.rtt_ms * 1000 / 2))});
  const Connection connection =
      Connection::open(link ? link->address() : server.address, kPatience).value();
  std::vector<std::unique_ptr<LoadClient>> clients;
  for (int i = 0; i < c.readers; ++i) {
    LoadOptions options{.session = "work",
                        .surface = surface,
                        .pictures_per_second = c.pictures_per_second,
                        .mix = {{1, 0, 0}},
                        .heartbeat_interval = milliseconds(2)};
    if (i == 0) options.mix = {{0, 1, 0}};
    clients.push_back(std::make_unique<LoadClient>(connection, options, 1 + i));
  }
  const Download download(link ? link->address() : server.address, c.download);
  const uint64_t bytes_before = link ? link->bytes_down() : 0;
  for (auto& client : clients) client->start(std::chrono::duration<double>(kSecondsPerCase));
  std::vector<LoadFigures> figures;
  for (auto& client : clients) {
    client->join();
    figures.push_back(client->figures());
  }
  auto report = load_report(figures, {});
  if (link)  // includes the link's other traffic
    report["bytes_per_second"] =
        static_cast<double>(link->bytes_down() - bytes_before) / figures[0].seconds;
  return report;
}

nlohmann::ordered_json figures_of(const Case& c, const nlohmann::ordered_json& report) {
  const auto& age = report["frame_age_ms"];
  const auto& drawn = report["drawn_age_ms"];
  return {{"reader", c.name},
          {"frames_per_s", report["frames_per_second"]},
          {"mbit_per_s", report["bytes_per_second"].get<double>() * 8e-6},
          {"age_p50_ms", age.value("p50", 0.0)},
          {"age_p95_ms", age.value("p95", 0.0)},
          {"age_p99_ms", age.value("p99", 0.0)},
          {"drawn_p50_ms", drawn.value("p50", 0.0)},
          {"drawn_p95_ms", drawn.value("p95", 0.0)},
          {"bar_ms", c.rtt_ms + kBarMs}};
}

void print_case(const nlohmann::ordered_json& row) {
  const auto value = [&](const char* key) { return row[key].get<double>(); };
  std::printf("%-28s %6.1f %7.1f   %6.1f %6.1f %6.1f   %6.1f %6.1f   %5.0f %s\n",
              row["reader"].get<std::string>().c_str(), value("frames_per_s"), value("mbit_per_s"),
              value("age_p50_ms"), value("age_p95_ms"), value("age_p99_ms"), value("drawn_p50_ms"),
              value("drawn_p95_ms"), value("bar_ms"),
              value("age_p95_ms") <= value("bar_ms") ? "met" : "MISSED");
  std::fflush(stdout);
}

void add_to_file(const std::string& path, const std::vector<nlohmann::ordered_json>& rows) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  if (std::ifstream before(path); before) all = nlohmann::ordered_json::parse(before);
  for (const nlohmann::ordered_json& row : rows) all.push_back(row);
  std::ofstream(path) << all.dump(1) << "\n";
}

double resident_megabytes(pid_t pid) {
  std::ifstream status("/proc/" + std::to_string(pid) + "/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("VmRSS:")) return std::stod(line.substr(6)) / 1024;
  return 0;
}

// One user works while another client of the session stands still.
void run_stopped_client(ServerProcess& server, const std::shared_ptr<const LoadSurface>& surface) {
  const auto other = server.start_burnish(
      {"bench", "serve", "--session", "work", "--seconds", "12", "--mix", "drag=1", "--json"});
  std::this_thread::sleep_for(seconds(4));
  const double before = resident_megabytes(server.process->pid());
  other->signal(SIGSTOP);
  const Connection connection = Connection::open(server.address, kPatience).value();
  LoadClient client(connection, {.session = "work", .surface = surface, .mix = {{0, 1, 0}}}, 2);
  client.start(seconds(12));
  double most = before;
  for (int i = 0; i < 110; ++i) {
    std::this_thread::sleep_for(milliseconds(100));
    most = std::max(most, resident_megabytes(server.process->pid()));
  }
  client.join();
  other->signal(SIGCONT);
  const int exit_code = other->wait(kPatience).value_or(-1);
  const LoadFigures figures = client.figures();
  std::printf(
      "\na client stopped for 12 s: the server's memory was %.1f MB, at most %.1f MB while "
      "another drew %.1f frames a second; the stopped one ended with %d afterwards\n",
      before, most, figures.frames / figures.seconds, exit_code);
}

int main_of(int argc, char** argv) {
  ServerProcess server;
  const std::string scan = argc > 1 ? argv[1] : (server.folder / "blob.ply").string();
  const int depth = argc > 2 ? std::stoi(argv[2]) : 0;
  if (argc < 2)
    must(write_mesh(generate_scan({.kind = "blob", .vertices = 100'000}).value(), scan));
  Connection connection = Connection::open(server.address, kPatience).value();
  must(connection.import_scan(scan, "scan", {depth, 0}, {}).status());
  must(connection.open_session({"scan", "work", {depth, 0}}).status());
  const size_t pages = argc > 3 ? std::stoul(argv[3]) : kLoadPages;
  const auto surface = fetch_load_surface(connection, "work", pages).value();
  std::printf("%zu vertices in %zu of %u pages, depth %d\n\n", surface->points.size(),
              surface->pages.size(), surface->head.page_count(), surface->depth);
  std::printf("%-28s %6s %7s   %-20s   %-13s\n", "", "frames", "Mbit/s", "age on arrival, ms",
              "when drawn");
  std::printf("%-28s %6s %7s   %6s %6s %6s   %6s %6s   %5s\n", "", "/ s", "", "p50", "p95", "p99",
              "p50", "p95", "bar");
  std::vector<nlohmann::ordered_json> rows;
  for (const Case& c : kCases) {
    rows.push_back(figures_of(c, run_case(server, surface, c)));
    rows.back()["vertices"] = surface->points.size();
    print_case(rows.back());
  }
  if (argc > 4) add_to_file(argv[4], rows);
  run_stopped_client(server, surface);
  return 0;
}

}  // namespace
}  // namespace burnish

int main(int argc, char** argv) {
  return burnish::main_of(argc, argv);
}
