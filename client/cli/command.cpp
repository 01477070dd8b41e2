#include "client/cli/command.h"

#include <iostream>

namespace burnish {

static constexpr int kExitFailed = 1;
static constexpr int kExitUsage = 2;

CLI::App* CommandTable::add(const std::string& name, const std::string& description,
                            std::function<Status()> run) {
  CLI::App* command = app_.add_subcommand(name, description);
  command->final_callback([this, run = std::move(run)] { chosen_ = run; });
  return command;
}

static bool has_command(const CLI::App& app, const std::string& name) {
  return !app.get_subcommands([&](const CLI::App* one) { return one->get_name() == name; }).empty();
}

int CommandTable::run(int argc, char** argv) {
  if (argc > 1 && argv[1][0] != '-' && !has_command(app_, argv[1])) {
    std::cerr << app_.get_name() << ": '" << argv[1]
              << "' is neither a command nor a mesh file; --help lists the commands\n";
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
