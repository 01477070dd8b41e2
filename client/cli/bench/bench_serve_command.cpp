#include <algorithm>
#include <iostream>
#include <map>
#include <memory>

#include "client/cli/bench/load_client.h"
#include "client/cli/bench/load_report.h"
#include "client/cli/commands.h"
#include "client/cli/in_range.h"
#include "client/cli/print_json.h"
#include "client/cli/server_option.h"
#include "common/base/limits.h"
#include "common/edit/edit_id.h"

namespace burnish {

namespace {

constexpr std::chrono::seconds kSettlePatience{300};

struct BenchOptions {
  ServerOption server;
  std::vector<std::string> sessions;
  int clients = 1;
  double seconds = 10;
  double pictures_per_second = 60;
  size_t pages = kLoadPages;
  uint32_t seed = 1;
  std::string mix = "draw=1,drag=1,paint=2";
};

/// The clients of a run and their connections. Sessions get clients in turn.
struct Load {
  struct Slot {
    std::string session;
    std::unique_ptr<Connection> connection;
    std::unique_ptr<LoadClient> client;
  };
  std::vector<Slot> slots;
};

Result<Load> connect_clients(const BenchOptions& options, const LoadMix& mix) {
  ASSIGN_OR_RETURN(Connection connection, options.server.connect());
  std::map<std::string, std::shared_ptr<const LoadSurface>> surfaces;
  for (const std::string& session : options.sessions) {
    ASSIGN_OR_RETURN(surfaces[session], fetch_load_surface(connection, session, options.pages));
  }
  Load load;
  for (int i = 0; i < options.clients; ++i) {
    Load::Slot slot{options.sessions[static_cast<size_t>(i) % options.sessions.size()]};
    ASSIGN_OR_RETURN(Connection own, options.server.connect());
    slot.connection = std::make_unique<Connection>(std::move(own));
    const LoadOptions client{.session = slot.session,
                             .surface = surfaces[slot.session],
                             .pictures_per_second = options.pictures_per_second,
                             .mix = mix};
    slot.client = std::make_unique<LoadClient>(*slot.connection, client,
                                               options.seed + static_cast<uint32_t>(i));
    load.slots.push_back(std::move(slot));
  }
  return load;
}

/// Checks a fork, which is made by replay: its fields must equal those of the session that grew
/// edit by edit.
Result<bool> replay_agrees(Connection& connection, const std::string& session) {
  ForkWish wish;
  wish.source = session;
  wish.name = "bench replay " + random_id();
  ASSIGN_OR_RETURN(const ForkedSession forked, connection.fork_session(wish));
  const SessionInfo& fork = forked.session;
  bool agrees = true;
  for (const CellValue value : {CellValue::kBeta, CellValue::kAlpha1, CellValue::kAlpha2}) {
    ASSIGN_OR_RETURN(const auto grown, connection.cells(session, value));
    ASSIGN_OR_RETURN(const auto replayed, connection.cells(fork.id, value));
    agrees = agrees && grown == replayed;
  }
  RETURN_IF_ERROR(connection.delete_session(fork.id));
  return agrees;
}

Status check_session(Connection& connection, const std::string& session, Load& load,
                     LoadChecks& checks) {
  ASSIGN_OR_RETURN(const std::vector<HistoryEntry> history, connection.history(session));
  ASSIGN_OR_RETURN(const SessionState state, connection.state(session));
  std::set<std::string> ids;
  for (const HistoryEntry& entry : history) ids.insert(entry.edit_id);
  std::set<uint64_t> shown;
  for (Load::Slot& slot : load.slots) {
    if (slot.session != session) continue;
    const LoadFigures& figures = slot.client->figures();
    for (const std::string& id : figures.acknowledged)
      if (!ids.contains(id)) ++checks.missing_from_history;
    checks.acknowledged += figures.acknowledged.size();
    checks.unanswered += figures.applied - figures.acknowledged.size() - figures.refused.size();
    for (const std::string& why : figures.refused) checks.objections.push_back("refused: " + why);
    if (!figures.ended.empty()) checks.objections.push_back("ended early: " + figures.ended);
    if (!slot.client->settle(state.session.edits, kSettlePatience))
      checks.objections.push_back("a client of session " + session + " did not settle");
    shown.insert(slot.client->shown_hash());
  }
  checks.clients_agree = checks.clients_agree && shown.size() <= 1;
  ASSIGN_OR_RETURN(const bool agrees, replay_agrees(connection, session));
  checks.replay_agrees = checks.replay_agrees && agrees;
  return Status::ok();
}

Result<LoadChecks> check(const BenchOptions& options, Load& load) {
  ASSIGN_OR_RETURN(Connection connection, options.server.connect());
  LoadChecks checks;
  checks.clients_agree = checks.replay_agrees = true;
  for (const std::string& session : options.sessions)
    RETURN_IF_ERROR(check_session(connection, session, load, checks));
  if (checks.missing_from_history > 0)
    checks.objections.push_back("acknowledged edits are missing from the history");
  if (checks.unanswered > 0) checks.objections.push_back("edits were not answered");
  if (!checks.clients_agree) checks.objections.push_back("clients show different surfaces");
  if (!checks.replay_agrees) checks.objections.push_back("a replay gives different fields");
  return checks;
}

Status bench(const BenchOptions& options) {
  ASSIGN_OR_RETURN(const LoadMix mix, parse_load_mix(options.mix));
  ASSIGN_OR_RETURN(Load load, connect_clients(options, mix));
  for (Load::Slot& slot : load.slots)
    slot.client->start(std::chrono::duration<double>(options.seconds));
  for (Load::Slot& slot : load.slots) slot.client->join();
  ASSIGN_OR_RETURN(const LoadChecks checks, check(options, load));
  std::vector<LoadFigures> figures;
  for (Load::Slot& slot : load.slots) figures.push_back(slot.client->figures());
  const nlohmann::ordered_json report = load_report(figures, checks);
  if (options.server.json) {
    print_json(report);
  } else {
    print_load_report(report);
  }
  return checks.is_good() ? Status::ok() : data_loss(checks.objections.front());
}

}  // namespace

void add_bench_command(CommandTable& table) {
  const auto options = std::make_shared<BenchOptions>();
  CLI::App* command = table.add("bench", "Measure a server", [options] { return bench(*options); });
  command->require_subcommand(1);
  CLI::App* serve = command->add_subcommand(
      "serve", "Run many clients that look, drag and paint; check that nothing is lost");
  serve
      ->add_option("--session", options->sessions,
                   "Name or id; clients are shared out among several")
      ->required();
  serve->add_option("--clients", options->clients, "Connections at once")
      ->check(in_range(1, 1000))
      ->capture_default_str();
  serve->add_option("--seconds", options->seconds, "How long")
      ->check(in_range(0.1, 86400.0))
      ->capture_default_str();
  serve->add_option("--mix", options->mix, "How often clients do each action")
      ->check([](const std::string& text) { return usage_message(parse_load_mix(text).status()); })
      ->capture_default_str();
  serve->add_option("--rate", options->pictures_per_second, "Pictures per second of a client")
      ->check(in_range(1.0, 240.0))
      ->capture_default_str();
  serve
      ->add_option("--pages", options->pages,
                   "Pages of the scan that clients show, the coarsest; 0: as many as they may")
      ->check(in_range(size_t{0}, kShownPagesMax))
      ->capture_default_str();
  serve->add_option("--seed", options->seed, "Seed of the gestures")->capture_default_str();
  add_server_options(*serve, options->server);
}

}  // namespace burnish
