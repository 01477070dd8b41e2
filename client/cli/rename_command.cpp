#include <iostream>
#include <memory>

#include "client/cli/commands.h"
#include "client/cli/json_output.h"
#include "client/cli/print_json.h"
#include "client/cli/server_option.h"

namespace burnish {

namespace {

struct RenameOptions {
  ServerOption server;
  std::string what;
  std::string subject;
  std::string name;
};

void tell_renamed(const RenameOptions& options, const std::string& name) {
  std::cout << "renamed " << options.what << " " << options.subject << " to " << name << "\n";
}

Status rename(const RenameOptions& options) {
  ASSIGN_OR_RETURN(Connection connection, options.server.connect());
  if (options.what == "scan") {
    ASSIGN_OR_RETURN(const ScanInfo scan, connection.rename_scan(options.subject, options.name));
    options.server.json ? print_json(to_json(scan)) : tell_renamed(options, scan.name);
    return Status::ok();
  }
  ASSIGN_OR_RETURN(const SessionInfo session,
                   connection.rename_session(options.subject, options.name));
  options.server.json ? print_json(to_json(session)) : tell_renamed(options, session.name);
  return Status::ok();
}

}  // namespace

void add_rename_command(CommandTable& table) {
  auto options = std::make_shared<RenameOptions>();
  CLI::App* command = table.add("rename", "Give a scan or a session another name",
                                [options] { return rename(*options); });
  command->add_option("WHAT", options->what, "scan or session")
      ->required()
      ->check(CLI::IsMember({"scan", "session"}));
  command->add_option("OLD", options->subject, "Name or id")->required();
  command->add_option("NEW", options->name, "The new name, 1 to 200 bytes")->required();
  add_server_options(*command, options->server);
}

}  // namespace burnish
