#include "client/app/window_command.h"

#include <memory>

#include "client/app/app.h"
#include "client/cli/server_option.h"
#include "client/pictures/lone_renderer.h"
#include "client/script/lone_script.h"
#include "client/script/script.h"
#include "client/tools/user_folders.h"
#include "common/base/limits.h"
#include "common/base/text_lines.h"

namespace burnish {

// ---- Scripts, without a window ----

static Status run_with(PageRenderer& renderer, const std::vector<ScriptLine>& script,
                       const std::string& name, const AppOptions& options) {
  ScriptOptions script_options{.server = options.server, .workspace = options.workspace};
  if (options.size.width > 0) script_options.size = options.size;
  LoneScript runner(renderer, std::move(script_options));
  if (!options.record.empty()) RETURN_IF_ERROR(runner.workspace().recorder.open(options.record));
  return runner.run(script, name);
}

/// Pictures of scripts take their time, and show full detail.
static PageBudget script_budget(uint64_t triangles_max) {
  return {.triangles = triangles_max > 0 ? triangles_max : 20'000'000,
          .resident_bytes = 4'000'000'000,
          .card_bytes = 2'000'000'000};
}

// Runs a script without a window, and draws with LoneRenderer.
static Status run_script_file(const std::filesystem::path& script, AppOptions options) {
  ASSIGN_OR_RETURN(const std::string text, read_text_file(script));
  ASSIGN_OR_RETURN(const std::vector<ScriptLine> lines, parse_script(text, script.string()));
  options.workspace.preferences.clear();  // a script leaves no traces
  options.workspace.pages.clear();
  options.workspace.budget = script_budget(options.triangles_max);
  const LoneRenderer renderer;
  return run_with(*renderer, lines, script.string(), options);
}

// ---- The command ----

namespace {

struct Options {
  ServerOption server;
  AppOptions app;
  std::filesystem::path config;
  std::filesystem::path data;
  std::filesystem::path script;
  std::filesystem::path record;
};

Status run(const Options& given) {
  AppOptions app = given.app;
  app.server = given.server.server;
  ASSIGN_OR_RETURN(app.workspace.trust, given.server.full_trust());
  app.workspace.timeout =
      std::chrono::milliseconds(static_cast<int64_t>(given.server.timeout_seconds * 1000));
  app.workspace.preferences = given.config.empty() ? preferences_path() : given.config;
  const std::filesystem::path cache = cache_folder();
  app.workspace.pages = cache.empty() ? cache : cache / "pages";
  app.workspace.private_server.data = given.data.empty() ? data_folder() : given.data;
  ASSIGN_OR_RETURN(Preferences preferences, read_preferences(app.workspace.preferences));
  if (!given.server.user.empty()) preferences.user = given.server.user;
  app.record = given.record;
  if (!given.script.empty()) return run_script_file(given.script, std::move(app));
  return App::run(std::move(app), std::move(preferences));
}

}  // namespace

void add_window_command(CommandTable& table) {
  auto options = std::make_shared<Options>();
  options->server.server.clear();
  CLI::App* command = table.add("window", "Edit a scan in a window (also: burnish [SCAN])",
                                [options] { return run(*options); });
  command->add_option("SCAN", options->app.scan, "Mesh file to import and open")
      ->check(CLI::ExistingFile);
  command->add_option("--session", options->app.session, "Session to join, by name or id");
  command->add_option("--scale", options->app.scale, "Size of fonts and panels; 1 is normal")
      ->check(CLI::Range(0.5, 4.0));
  command->add_option("--width", options->app.size.width, "Of the window, in pixels")
      ->check(CLI::Range(320, kImageSidePixelsMax));
  command->add_option("--height", options->app.size.height, "Of the window, in pixels")
      ->check(CLI::Range(240, kImageSidePixelsMax));
  command->add_option("--triangles", options->app.triangles_max,
                      "Draw at most this many in a picture; edits and exports use all");
  command->add_option("--config", options->config, "Configuration file");
  command->add_option("--data", options->data, "Folder of the private server");
  command
      ->add_option("--script", options->script, "Run the commands of this file, without a window")
      ->check(CLI::ExistingFile);
  command->add_option("--record", options->record, "Write what you do in the window as a script");
  command->add_option("--places", options->app.places, "Write where widgets are, for tests")
      ->group("");  // no help
  command->footer("A script has one command per line:\n" + script_help());
  add_server_options(*command, options->server);
  command->remove_option(command->get_option("--json"));  // scripts print text
}

}  // namespace burnish
