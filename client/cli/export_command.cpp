#include <cstdio>
#include <memory>

#include "client/cli/commands.h"
#include "client/cli/in_range.h"
#include "client/cli/json_output.h"
#include "client/cli/print_json.h"
#include "client/cli/progress_printer.h"
#include "client/cli/server_option.h"
#include "client/cli/warn_of_left_out.h"
#include "client/connection/export_files.h"
#include "client/report/processing_record.h"
#include "common/base/atomic_file.h"
#include "common/mesh/mesh_format.h"

namespace burnish {

namespace {

struct ExportOptions {
  ServerOption server;
  std::string session;
  std::string out;
  bool force = false;
  std::string record;  ///< file; empty: none
  ExportWish wish;
};

void print(const ExportSummary& summary, const std::string& out) {
  std::printf("%s: %llu vertices, %llu triangles, %llu bytes; %d cycles in %.2f s, distance %.2g\n",
              out.c_str(), static_cast<unsigned long long>(summary.vertices),
              static_cast<unsigned long long>(summary.triangles),
              static_cast<unsigned long long>(summary.size_bytes), summary.cycles,
              summary.assemble_seconds + summary.solve_seconds, summary.distance);
  if (!summary.pictures.empty()) std::printf("%s: %s\n", out.c_str(), summary.pictures.c_str());
}

Status write_record_of(const ExportOptions& options, const ExportedFiles& exported,
                       Connection& connection) {
  const RecordedExport made{options.server.user, exported.mesh, exported.summary};
  const auto record = make_processing_record(connection, options.session, made);
  RETURN_IF_ERROR(record.status().with_context("record of " + options.session));
  return write_record(*record, options.record);
}

Status run(const ExportOptions& options) {
  ExportWish wish = options.wish;
  wish.deviation = !options.record.empty();
  ASSIGN_OR_RETURN(const ExportTarget target, export_target(options.out, options.force));
  if (!options.record.empty()) RETURN_IF_ERROR(check_writable(options.record));
  ASSIGN_OR_RETURN(Connection connection, options.server.connect());
  ProgressPrinter printer;
  const auto exported = export_files(connection, options.session, wish, target, printer.progress());
  if (!exported.is_ok()) return exported.status().with_context("export of " + options.session);
  warn_of_left_out(exported->summary.left_out, options.out);
  if (!exported->summary.lost_volume.empty())
    std::fprintf(stderr, "warning: %s\n", exported->summary.lost_volume.c_str());
  if (wish.deviation) RETURN_IF_ERROR(write_record_of(options, *exported, connection));
  if (options.server.json) {
    print_json(to_json(exported->summary));
  } else {
    print(exported->summary, exported->mesh.string());
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
          "File to write: " + extensions_text() +
              "; or a folder. The scan's own format keeps all that it has, with the files beside "
              "it")
      ->required();
  command->add_flag("--force", options->force,
                    "Replace files beside OUT that are there with other content");
  command
      ->add_option("--record", options->record,
                   "Also write who did what: a page (.html) or JSON (.json)")
      ->type_name("FILE")
      ->check([](const std::string& file) { return usage_message(check_record_name(file)); });
  CLI::Option* exact =
      command->add_flag("--exact", options->wish.exact, "Solve to the accuracy of final results");
  command->add_option("--cycles", options->wish.cycles, "Solve with this many cycles")
      ->check(in_range(1, kExportCyclesMax))
      ->excludes(exact);
  add_server_options(*command, options->server);
}

}  // namespace burnish
