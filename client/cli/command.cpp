#include "client/cli/command.h"

#include <algorithm>
#include <iostream>
#include <vector>

#include "common/base/nearest_word.h"

namespace burnish {

static constexpr int kExitFailed = 1;
static constexpr int kExitUsage = 2;

CLI::App* CommandTable::add(const std::string& name, const std::string& description,
                            std::function<Status()> run) {
  CLI::App* command = app_.add_subcommand(name, description);
  command->final_callback([this, run = std::move(run)] { chosen_ = run; });
  return command;
}

static std::vector<std::string> commands_of(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(command->get_name());
  return names;
}

int CommandTable::run(int argc, char** argv) {
  const std::vector<std::string> commands = commands_of(app_);
  if (argc > 1 && argv[1][0] != '-' && std::ranges::find(commands, argv[1]) == commands.end()) {
    std::cerr << app_.get_name() << ": '" << argv[1]
              << "' is neither a command nor a mesh file; --help lists the commands"
              << did_you_mean(argv[1], commands) << "\n";
    return kExitUsage;
  }
  app_.require_subcommand(1);
  try {
    app_.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app_.exit(error) == 0 ? 0 : kExitUsage;  // 0 after --help and --version
  }
  const Status status = chosen_();
  if (status.is_ok()) return 0;
  std::cerr << app_.get_name() << ": " << status.message() << "\n";
  return kExitFailed;
}

}  // namespace burnish
