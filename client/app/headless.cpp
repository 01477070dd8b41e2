#include "client/app/headless.h"

#include "client/pictures/lone_renderer.h"
#include "client/script/lone_script.h"
#include "common/base/text_lines.h"

namespace burnish {

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

Status run_script_file(const std::filesystem::path& script, AppOptions options) {
  ASSIGN_OR_RETURN(const std::string text, read_text_file(script));
  ASSIGN_OR_RETURN(const std::vector<ScriptLine> lines, parse_script(text, script.string()));
  options.workspace.preferences.clear();  // a script leaves no traces
  options.workspace.pages.clear();
  options.workspace.budget = script_budget(options.triangles_max);
  const LoneRenderer renderer;
  return run_with(*renderer, lines, script.string(), options);
}

}  // namespace burnish
