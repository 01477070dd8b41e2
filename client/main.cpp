#include <csignal>
#include <iostream>

#include "client/cli/command.h"
#include "client/cli/commands.h"

int main(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);  // a file beyond a quota is an error of the write
  CLI::App app("Burnish: smooths and sharpens scanned surfaces.", "burnish");
  app.set_version_flag("--version", "burnish " BURNISH_VERSION);
  app.footer("burnish COMMAND --help says more of a command.");
  burnish::CommandTable table(app);
  burnish::add_generate_command(table);
  burnish::add_filter_command(table);
  burnish::add_render_command(table);
  burnish::add_service_commands(table);
  if (argc < 2) {
    std::cerr << app.help() << "\nburnish: name a command\n";
    return 2;
  }
  return table.run(argc, argv);
}
