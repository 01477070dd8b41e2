#include <iostream>
#include <memory>

#include "client/cli/commands.h"
#include "client/cli/json_output.h"
#include "client/cli/print_json.h"
#include "client/cli/server_option.h"

namespace burnish {

namespace {

struct OpenOptions {
  ServerOption server;
  SessionWish wish;
};

Status run(const OpenOptions& options) {
  ASSIGN_OR_RETURN(Connection connection, options.server.connect());
  ASSIGN_OR_RETURN(const OpenedSession opened, connection.open_session(options.wish));
  const SessionInfo& session = opened.session;
  if (options.server.json) {
    auto json = to_json(session);
    json["attached"] = opened.attached;
    print_json(json);
    return Status::ok();
  }
  std::cout << (opened.attached ? "attached to " : "opened ") << session.name << ": scan "
            << short_id(session.scan_id) << ", depth " << session.key.depth << ", " << session.edits
            << (session.edits == 1 ? " edit\n" : " edits\n");
  return Status::ok();
}

}  // namespace

void add_open_command(CommandTable& table) {
  auto options = std::make_shared<OpenOptions>();
  CLI::App* command = table.add("open", "Open a session over a scan, or attach to it",
                                [options] { return run(*options); });
  command->add_option("SCAN", options->wish.scan, "Name, id, or the beginning of an id")
      ->required();
  command->add_option("--session", options->wish.name,
                      "The session's name; left out: the server chooses");
  add_prepared_options(*command, options->wish.key);
  add_server_options(*command, options->server);
}

}  // namespace burnish
