#include <cstdio>
#include <memory>

#include "client/cli/commands.h"
#include "client/cli/json_output.h"
#include "client/cli/progress_printer.h"
#include "client/cli/server_option.h"
#include "client/cli/warn_of_left_out.h"
#include "common/base/atomic_file.h"

namespace burnish {

namespace {

struct ExportOptions {
  ServerOption server;
  std::string session;
  std::string out;
  ExportWish wish;
};

void print(const ExportSummary& summary, const std::string& out) {
  std::printf("%s: %llu vertices, %llu triangles, %llu bytes; %d cycles in %.2f s, distance %.2g\n",
              out.c_str(), static_cast<unsigned long long>(summary.vertices),
              static_cast<unsigned long long>(summary.triangles),
              static_cast<unsigned long long>(summary.size_bytes), summary.cycles,
              summary.assemble_seconds + summary.solve_seconds, summary.distance);
}

Status run(const ExportOptions& options) {
  ExportWish wish = options.wish;
  ASSIGN_OR_RETURN(wish.format, written_format_of_path(options.out));
  RETURN_IF_ERROR(check_writable(options.out));
  ASSIGN_OR_RETURN(Connection connection, options.server.connect());
  ProgressPrinter printer;
  const auto summary =
      connection.export_mesh(options.session, wish, options.out, printer.progress());
  if (!summary.is_ok()) return summary.status().with_context("export of " + options.session);
  warn_of_left_out(summary->left_out, options.out);
  if (options.server.json) {
    print_json(to_json(summary.value()));
  } else {
    print(summary.value(), options.out);
  }
  return Status::ok();
}

}  // namespace

void add_export_command(CommandTable& table) {
  auto options = std::make_shared<ExportOptions>();
  CLI::App* command =
      table.add("export", "Write a session's edited mesh", [options] { return run(*options); });
  command->add_option("SESSION", options->session, "Name or id")->required();
  command
      ->add_option(
          "OUT", options->out,
          "File to write: .ply, .obj, .stl or .off; the scan's own format keeps all that it has")
      ->required();
  CLI::Option* exact =
      command->add_flag("--exact", options->wish.exact, "Solve to the accuracy of final results");
  command->add_option("--cycles", options->wish.cycles, "Solve with this many cycles")
      ->check(CLI::Range(1, kExportCyclesMax))
      ->excludes(exact);
  add_server_options(*command, options->server);
}

}  // namespace burnish
