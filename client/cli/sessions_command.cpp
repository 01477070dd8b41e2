#include <cstdio>
#include <memory>

#include "client/cli/commands.h"
#include "client/cli/json_output.h"
#include "client/cli/print_json.h"
#include "client/cli/server_option.h"

namespace burnish {

namespace {

struct SessionsOptions {
  ServerOption server;
  std::string session;
};

void print(const SessionInfo& session) {
  std::printf("%s  %s  %5d  %6llu  %-9s  %s\n", session.id.c_str(),
              short_id(session.scan_id).c_str(), session.key.depth,
              static_cast<unsigned long long>(session.edits), session.in_memory ? "yes" : "no",
              session.name.c_str());
}

Status list(Connection& connection, bool json) {
  ASSIGN_OR_RETURN(const auto sessions, connection.list_sessions());
  if (json) {
    auto array = nlohmann::ordered_json::array();
    for (const SessionInfo& session : sessions) array.push_back(to_json(session));
    print_json(array);
    return Status::ok();
  }
  std::printf("%-16s  %-12s  %5s  %6s  %-9s  %s\n", "id", "scan", "depth", "edits", "in memory",
              "name");
  for (const SessionInfo& session : sessions) print(session);
  return Status::ok();
}

Status show(Connection& connection, const std::string& name, bool json) {
  ASSIGN_OR_RETURN(const SessionState state, connection.state(name));
  if (json) {
    print_json(to_json(state));
    return Status::ok();
  }
  std::printf("%-14s %s (%s)\n", "session", state.session.name.c_str(), state.session.id.c_str());
  std::printf("%-14s %s at depth %d\n", "scan", short_id(state.session.scan_id).c_str(),
              state.session.key.depth);
  std::printf("%-14s %llu\n", "edits", static_cast<unsigned long long>(state.session.edits));
  for (const SettingText& setting : texts_of(state.settings))
    std::printf("%-14s %s\n", setting.key, setting.text.c_str());
  if (state.rims > 0)
    std::printf("%-14s %llu of %llu stay\n", "rims",
                static_cast<unsigned long long>(state.rims_held),
                static_cast<unsigned long long>(state.rims));
  if (const std::string walls = describe(state.walls); !walls.empty())
    std::printf("%s\n", walls.c_str());
  std::printf("%-14s %s, %llu bytes\n", "solver", state.backend.c_str(),
              static_cast<unsigned long long>(state.memory_bytes));
  if (state.cycles > 0)
    std::printf("%-14s %d, energy %.6g, residual %.3g, distance %.3g\n", "cycles", state.cycles,
                state.energy, state.residual, state.distance);
  return Status::ok();
}

Status run(const SessionsOptions& options) {
  ASSIGN_OR_RETURN(Connection connection, options.server.connect());
  return options.session.empty() ? list(connection, options.server.json)
                                 : show(connection, options.session, options.server.json);
}

}  // namespace

void add_sessions_command(CommandTable& table) {
  auto options = std::make_shared<SessionsOptions>();
  CLI::App* command = table.add("sessions", "List the server's sessions, or show one",
                                [options] { return run(*options); });
  command->add_option("SESSION", options->session, "Name or id of the one to show");
  add_server_options(*command, options->server);
}

}  // namespace burnish
