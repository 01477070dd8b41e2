#include <csignal>
#include <iostream>
#include <vector>

#include "client/app/window_command.h"
#include "client/cli/command.h"
#include "client/cli/commands.h"
#include "common/base/wait_policy.h"
#include "common/mesh/mesh_format.h"

static char kWindow[] = "window";

// Returns true if the build has a window and the command line is empty, or begins with a mesh file
// or an option.
static bool means_window(const CLI::App& app, const std::vector<char*>& words) {
  const auto windows =
      app.get_subcommands([](const CLI::App* one) { return one->get_name() == kWindow; });
  if (windows.empty()) return false;
  if (words.size() < 2) return true;
  const std::string first = words[1];
  if (first == "-h" || first == "--help" || first == "--version") return false;
  return first.starts_with("--") || burnish::mesh_format_of_path(first).is_ok();
}

int main(int argc, char** argv) {
  burnish::sleep_while_waiting(argv);
  std::signal(SIGXFSZ, SIG_IGN);  // beyond a file size limit, write() fails instead
  CLI::App app("Burnish: smooths and sharpens scanned surfaces.", "burnish");
  app.set_version_flag("--version", "burnish " BURNISH_VERSION);
  app.footer("burnish COMMAND --help describes a command.");
  burnish::CommandTable table(app);
  burnish::add_window_command(table);
  burnish::add_generate_command(table);
  burnish::add_filter_command(table);
  burnish::add_watch_command(table);
  burnish::add_presets_command(table);
  burnish::add_render_command(table);
  burnish::add_service_commands(table);
  std::vector<char*> words(argv, argv + argc);
  if (means_window(app, words)) words.insert(words.begin() + 1, kWindow);
  if (words.size() < 2) {
    std::cerr << app.help() << "\nburnish: name a command\n";
    return 2;
  }
  return table.run(static_cast<int>(words.size()), words.data());
}
