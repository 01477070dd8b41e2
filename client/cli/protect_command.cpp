#include <iostream>
#include <memory>

#include "client/cli/commands.h"
#include "client/cli/print_json.h"
#include "client/cli/server_option.h"
#include "common/edit/edit_id.h"
#include "common/edit/protect_words.h"

namespace burnish {

namespace {

struct ProtectOptions {
  ServerOption server;
  std::string session;
  std::vector<std::string> words;
};

Status run_protect(const ProtectOptions& options) {
  ASSIGN_OR_RETURN(const Protect change, parse_protect(options.words));
  ASSIGN_OR_RETURN(Connection connection, options.server.connect());
  const std::vector<Edit> edits = {{random_id(), change}};
  ASSIGN_OR_RETURN(const ApplyOutcome outcome, connection.apply(options.session, edits));
  if (options.server.json) {
    print_json({{"applied", outcome.applied}, {"edits", outcome.edits}});
  } else {
    std::cout << options.session << ": " << summary(change) << "\n";
  }
  return Status::ok();
}

}  // namespace

void add_protect_command(CommandTable& table) {
  auto options = std::make_shared<ProtectOptions>();
  CLI::App* command = table.add("protect", "Choose a region in which nothing moves",
                                [options] { return run_protect(*options); });
  command->add_option("SESSION", options->session, "Name or id")->required();
  command
      ->add_option(
          "WORDS", options->words,
          "curvature LEAST MOST, piece X Y Z, lasso M1 ... M16 X Y X Y ..., through ... for\n"
          "a lasso that goes through; 'release' before them takes cells out; grow CELLS,\n"
          "shrink CELLS, invert, clear")
      ->required();
  add_server_options(*command, options->server);
}

}  // namespace burnish
