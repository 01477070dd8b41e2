// Commands about forks of a session and the people in it.

#include <iostream>
#include <map>
#include <memory>

#include "client/cli/commands.h"
#include "client/cli/in_range.h"
#include "client/cli/json_output.h"
#include "client/cli/print_json.h"
#include "client/cli/server_option.h"
#include "common/base/limits.h"

namespace burnish {

namespace {

struct ForkOptions {
  ServerOption server;
  ForkWish wish;
};

Status fork(const ForkOptions& options) {
  ASSIGN_OR_RETURN(Connection connection, options.server.connect());
  ASSIGN_OR_RETURN(const ForkedSession forked, connection.fork_session(options.wish));
  const SessionInfo& session = forked.session;
  if (options.server.json) {
    print_json(to_json(session));
  } else {
    std::cout << "forked " << options.wish.source << ": " << session.name << ", " << session.edits
              << (session.edits == 1 ? " edit\n" : " edits\n");
    if (forked.emptied_edits > 0)
      std::cout << "without the cells that " << forked.emptied_edits
                << " of them set: another depth has other cells\n";
  }
  return Status::ok();
}

struct PeopleOptions {
  ServerOption server;
  std::string session;
  std::string subject;
  bool others = false;
  SessionRole role = SessionRole::kViewer;
};

void print(const SessionPeople& people) {
  for (const auto& [user, role] : people.roles.by_user())
    std::cout << session_role_name(role) << "  " << (user.empty() ? "(everybody else)" : user)
              << "\n";
  for (const PresentUser& user : people.present)
    std::cout << "present  " << (user.user.empty() ? "(without a name)" : user.user) << "\n";
}

Status people(const PeopleOptions& options, bool give_role) {
  ASSIGN_OR_RETURN(Connection connection, options.server.connect());
  if (give_role)
    RETURN_IF_ERROR(connection.set_role(options.session, options.subject, options.role));
  ASSIGN_OR_RETURN(const SessionPeople all, connection.people(options.session));
  if (options.server.json) {
    print_json(to_json(all));
  } else {
    print(all);
  }
  return Status::ok();
}

}  // namespace

void add_fork_command(CommandTable& table) {
  auto options = std::make_shared<ForkOptions>();
  CLI::App* command =
      table.add("fork", "Open a new session with the edits of another, or some of them",
                [options] { return fork(*options); });
  command->add_option("SESSION", options->wish.source, "Name or id of the one to fork")->required();
  command->add_option("--session", options->wish.name,
                      "The new session's name; left out: the server chooses");
  CLI::Option* number =
      command->add_option("--until", options->wish.number, "Number of the last edit to copy")
          ->check(in_range(uint64_t{1}, uint64_t{1} << 62))
          ->type_name("NUMBER");
  command
      ->add_option("--checkpoint", options->wish.checkpoint, "Copy the edits up to this checkpoint")
      ->type_name("NAME")
      ->excludes(number);
  command->add_option("--depth", options->wish.depth, "The new session's depth; left out: the same")
      ->check(in_range(kDepthMin, kDepthMax))
      ->type_name("DEPTH");
  add_server_options(*command, options->server);
}

void add_people_command(CommandTable& table) {
  auto options = std::make_shared<PeopleOptions>();
  CLI::App* command = table.add(
      "people", "Show who may do what in a session, or give somebody a role",
      [options] { return people(*options, !options->subject.empty() || options->others); });
  command->add_option("SESSION", options->session, "Name or id")->required();
  CLI::Option* user =
      command->add_option("--give", options->subject, "Who gets the role")->type_name("USER");
  CLI::Option* others =
      command->add_flag("--others", options->others, "Everybody without a role gets it")
          ->excludes(user);
  const std::map<std::string, SessionRole> roles = {{"viewer", SessionRole::kViewer},
                                                    {"editor", SessionRole::kEditor},
                                                    {"owner", SessionRole::kOwner}};
  CLI::Option* role = command->add_option("--role", options->role, "viewer, editor or owner")
                          ->transform(CLI::CheckedTransformer(roles))
                          ->type_name("ROLE");
  user->needs(role);
  others->needs(role);
  add_server_options(*command, options->server);
}

}  // namespace burnish
