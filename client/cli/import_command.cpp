#include <iostream>
#include <memory>

#include "client/cli/commands.h"
#include "client/cli/json_output.h"
#include "client/cli/print_json.h"
#include "client/cli/progress_printer.h"
#include "client/cli/server_option.h"
#include "client/report/depth_text.h"
#include "common/base/text.h"
#include "common/bundle/scan_bundle.h"
#include "common/mesh/mesh_format.h"
#include "common/mesh/rewrite/left_out/left_out.h"

namespace burnish {

namespace {

struct ImportOptions {
  ServerOption server;
  std::string file;
  std::string name;
  bool alone = false;  ///< without the files beside it
  PreparedKey key;
};

void print(const ImportOutcome& outcome) {
  const ScanInfo& scan = outcome.scan;
  std::cout << (outcome.already_present ? "already there: " : "imported ") << scan.name << " ("
            << short_id(scan.id) << "), " << scan.statistics.vertices << " vertices, "
            << scan.statistics.triangles << " triangles, default depth " << scan.default_depth
            << "\n"
            << edges_text(scan.statistics, scan.unit, scan.default_depth) << "\n";
}

void tell_of_files_beside(const ScanBundle& bundle) {
  if (!bundle.beside().empty())
    std::cout << "with " << bundle.beside().size()
              << (bundle.beside().size() == 1 ? " file" : " files")
              << " that it names: " << left_out_text(bundle.beside()) << "\n";
}

void warn_of_missing(const ScanBundle& bundle) {
  if (!bundle.missing().empty())
    std::cerr << "warning: " << missing_text(bundle.mesh().string(), bundle.missing()) << "\n";
}

Status run(const ImportOptions& options) {
  auto opened = ScanBundle::open(options.file, options.alone);
  if (!opened.is_ok()) return opened.status().with_context("import of " + options.file);
  const ScanBundle& bundle = *opened;
  ASSIGN_OR_RETURN(Connection connection, options.server.connect());
  const std::string name = options.name.empty() ? bundle.mesh().stem().string() : options.name;
  if (!options.alone) warn_of_missing(bundle);
  ProgressPrinter printer;
  auto outcome =
      connection.import_scan(bundle, name, options.key, printer.progress(), !options.name.empty());
  if (!outcome.is_ok()) return outcome.status().with_context("import of " + options.file);
  if (outcome->already_present && outcome->scan.name != name)
    std::cerr << "warning: the server has these bytes already; the scan keeps its name "
              << outcome->scan.name << ". To change it: burnish rename scan "
              << short_id(outcome->scan.id) << " '" << name << "'\n";
  if (options.name.empty() && !outcome->already_present && outcome->scan.name != name)
    std::cerr << "warning: another scan has the name " << name << ", or it may begin an id; "
              << "this one is " << outcome->scan.name << "\n";
  if (!options.server.json) {
    print(*outcome);
    tell_of_files_beside(bundle);
    return Status::ok();
  }
  auto json = to_json(outcome->scan);
  json["already_present"] = outcome->already_present;
  print_json(json);
  return Status::ok();
}

}  // namespace

void add_import_command(CommandTable& table) {
  auto options = std::make_shared<ImportOptions>();
  CLI::App* command = table.add("import", "Send a scan to the server, which prepares and keeps it",
                                [options] { return run(*options); });
  command
      ->add_option("SCAN", options->file,
                   "Mesh file: " + extensions_text() +
                       "; or a folder with one. Files that it names go along")
      ->required();
  command->add_flag("--alone", options->alone,
                    "Send the mesh file without the files that it names");
  command->add_option("--name", options->name, "Its name there; left out: the file's");
  add_prepared_options(*command, options->key);
  add_server_options(*command, options->server);
}

}  // namespace burnish
