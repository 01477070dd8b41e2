#include "client/cli/bench/load_report.h"

#include <algorithm>
#include <iomanip>
#include <iostream>

namespace burnish {

using nlohmann::ordered_json;

namespace {

ordered_json percentiles(std::vector<double> values) {
  if (values.empty()) return {{"count", 0}};
  std::ranges::sort(values);
  const auto at = [&](double fraction) {
    return values[static_cast<size_t>(fraction * static_cast<double>(values.size() - 1))];
  };
  return {{"count", values.size()},
          {"p50", at(0.5)},
          {"p95", at(0.95)},
          {"p99", at(0.99)},
          {"max", values.back()}};
}

std::vector<double> all_of(std::span<const LoadFigures> clients,
                           std::vector<double> LoadFigures::*member) {
  std::vector<double> all;
  for (const LoadFigures& client : clients)
    all.insert(all.end(), (client.*member).begin(), (client.*member).end());
  return all;
}

ordered_json report_of(const LoadFigures& client) {
  return {{"frames_per_second", client.frames / client.seconds},
          {"bytes_per_second", client.bytes / client.seconds},
          {"frame_age_ms", percentiles(client.age_ms)},
          {"edit_to_frame_ms", percentiles(client.edit_ms)},
          {"preview_to_frame_ms", percentiles(client.preview_ms)},
          {"edits", client.applied},
          {"refused", client.refused.size()},
          {"times_lost", client.times_lost}};
}

}  // namespace

ordered_json load_report(std::span<const LoadFigures> clients, const LoadChecks& checks) {
  ordered_json each = ordered_json::array();
  double slowest = 1e300, fastest = 0, bytes = 0, frames = 0;
  for (const LoadFigures& client : clients) {
    each.push_back(report_of(client));
    const double rate = client.frames / client.seconds;
    slowest = std::min(slowest, rate);
    fastest = std::max(fastest, rate);
    frames += rate;
    bytes += client.bytes / client.seconds;
  }
  ordered_json report = {
      {"clients", clients.size()},
      {"frames_per_second", frames / static_cast<double>(clients.size())},
      {"fairness_ratio", fastest > 0 ? slowest / fastest : 0},
      {"bytes_per_second", bytes},
      {"frame_age_ms", percentiles(all_of(clients, &LoadFigures::age_ms))},
      {"edit_to_frame_ms", percentiles(all_of(clients, &LoadFigures::edit_ms))},
      {"preview_to_frame_ms", percentiles(all_of(clients, &LoadFigures::preview_ms))},
      {"edits_acknowledged", checks.acknowledged},
      {"edits_unanswered", checks.unanswered},
      {"edits_missing_from_history", checks.missing_from_history},
      {"clients_agree", checks.clients_agree},
      {"replay_agrees", checks.replay_agrees},
      {"objections", checks.objections}};
  report["each"] = std::move(each);
  return report;
}

void print_load_report(const ordered_json& report) {
  const auto line = [](const std::string& name) -> std::ostream& {
    return std::cout << std::left << std::setw(26) << name << std::fixed << std::setprecision(1);
  };
  const auto times = [&](const std::string& name, const ordered_json& values) {
    if (values["count"] == 0) return;
    line(name) << "p50 " << values["p50"].get<double>() << "  p95 " << values["p95"].get<double>()
               << "  p99 " << values["p99"].get<double>() << "  max " << values["max"].get<double>()
               << " ms, of " << values["count"] << "\n";
  };
  line("frames per second") << report["frames_per_second"].get<double>() << " for each of "
                            << report["clients"] << " clients\n";
  line("slowest over fastest") << std::setprecision(2) << report["fairness_ratio"].get<double>()
                               << "\n";
  line("megabits per second") << report["bytes_per_second"].get<double>() * 8e-6 << " in all\n";
  times("frame age", report["frame_age_ms"]);
  times("edit to frame", report["edit_to_frame_ms"]);
  times("preview to frame", report["preview_to_frame_ms"]);
  line("edits acknowledged") << report["edits_acknowledged"] << ", "
                             << report["edits_missing_from_history"]
                             << " of them missing from the history\n";
}

}  // namespace burnish
