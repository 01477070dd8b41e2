#include <iostream>
#include <memory>

#include "client/cli/commands.h"
#include "client/cli/print_json.h"
#include "client/cli/server_option.h"

namespace burnish {

namespace {

struct RemoveOptions {
  ServerOption server;
  std::string subject;
  bool forget = false;
};

Status close_session(const RemoveOptions& options) {
  ASSIGN_OR_RETURN(Connection connection, options.server.connect());
  RETURN_IF_ERROR(options.forget ? connection.delete_session(options.subject)
                                 : connection.close_session(options.subject));
  const char* what = options.forget ? "deleted" : "closed";
  if (options.server.json) {
    print_json({{"session", options.subject}, {"done", what}});
  } else {
    std::cout << what << " session " << options.subject << "\n";
  }
  return Status::ok();
}

Status delete_scan(const RemoveOptions& options) {
  ASSIGN_OR_RETURN(Connection connection, options.server.connect());
  ASSIGN_OR_RETURN(const std::string id, connection.delete_scan(options.subject));
  if (options.server.json) {
    print_json({{"scan", id}, {"done", "deleted"}});
  } else {
    std::cout << "deleted scan " << options.subject << " (" << short_id(id) << ")\n";
  }
  return Status::ok();
}

}  // namespace

void add_close_command(CommandTable& table) {
  auto options = std::make_shared<RemoveOptions>();
  CLI::App* command = table.add("close", "Unload a session from memory; its edits stay",
                                [options] { return close_session(*options); });
  command->add_option("SESSION", options->subject, "Name or id")->required();
  command->add_flag("--delete", options->forget, "Delete its edits too");
  add_server_options(*command, options->server);
}

void add_delete_command(CommandTable& table) {
  auto options = std::make_shared<RemoveOptions>();
  CLI::App* command = table.add("delete", "Delete a scan that no session edits",
                                [options] { return delete_scan(*options); });
  command->add_option("SCAN", options->subject, "Name, id, or the beginning of an id")->required();
  add_server_options(*command, options->server);
}

}  // namespace burnish
