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

int CommandTable::run(int argc, char** argv) {
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
