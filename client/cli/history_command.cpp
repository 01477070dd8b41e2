#include <cstdio>
#include <ctime>
#include <iostream>
#include <memory>

#include "client/cli/commands.h"
#include "client/cli/json_output.h"
#include "client/cli/print_json.h"
#include "client/cli/server_option.h"
#include "common/edit/edit_id.h"

namespace burnish {

namespace {

struct HistoryOptions {
  ServerOption server;
  std::string session;
  std::vector<uint64_t> off, on;
};

std::string local_time(int64_t unix_ms) {
  const std::time_t seconds = unix_ms / 1000;
  std::tm parts = {};
  localtime_r(&seconds, &parts);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%d %H:%M:%S", &parts);
  return text;
}

Status switch_entries(const HistoryOptions& options, Connection& connection) {
  std::vector<Edit> edits;
  for (const uint64_t entry : options.off)
    edits.push_back({random_id(), SwitchEntry{entry, false}});
  for (const uint64_t entry : options.on) edits.push_back({random_id(), SwitchEntry{entry, true}});
  return edits.empty() ? Status::ok() : connection.apply(options.session, edits).status();
}

Status run(const HistoryOptions& options) {
  ASSIGN_OR_RETURN(Connection connection, options.server.connect());
  RETURN_IF_ERROR(switch_entries(options, connection));
  ASSIGN_OR_RETURN(const std::vector<HistoryEntry> history, connection.history(options.session));
  if (options.server.json) {
    auto array = nlohmann::ordered_json::array();
    for (const HistoryEntry& entry : history) array.push_back(to_json(entry));
    print_json(array);
    return Status::ok();
  }
  std::printf("%6s  %-3s  %-19s  %-12s  %-10s  %s\n", "number", "on", "time", "author", "kind",
              "what");
  for (const HistoryEntry& entry : history)
    std::printf("%6llu  %-3s  %-19s  %-12s  %-10s  %s\n",
                static_cast<unsigned long long>(entry.number), entry.enabled ? "on" : "off",
                local_time(entry.unix_ms).c_str(), entry.author.c_str(), edit_kind_name(entry.kind),
                entry.summary.c_str());
  return Status::ok();
}

}  // namespace

void add_history_command(CommandTable& table) {
  auto options = std::make_shared<HistoryOptions>();
  CLI::App* command = table.add("history", "List a session's edits; switch some off or on",
                                [options] { return run(*options); });
  command->add_option("SESSION", options->session, "Name or id")->required();
  command->add_option("--off", options->off, "Switch this entry off, even another user's")
      ->type_name("NUMBER");
  command->add_option("--on", options->on, "Switch this entry on again")->type_name("NUMBER");
  add_server_options(*command, options->server);
}

}  // namespace burnish
