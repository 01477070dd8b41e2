#include <filesystem>
#include <iostream>
#include <memory>

#include "client/cli/commands.h"
#include "client/cli/json_output.h"
#include "client/cli/progress_printer.h"
#include "client/cli/server_option.h"
#include "common/mesh/mesh_io.h"
#include "common/mesh/rewrite/left_out.h"

namespace burnish {

namespace {

struct ImportOptions {
  ServerOption server;
  std::string file;
  std::string name;
  PreparedKey key;
};

void print(const ImportOutcome& outcome) {
  const ScanInfo& scan = outcome.scan;
  std::cout << (outcome.already_present ? "already there: " : "imported ") << scan.name << " ("
            << short_id(scan.id) << "), " << scan.statistics.vertices << " vertices, "
            << scan.statistics.triangles << " triangles, default depth " << scan.default_depth
            << "\n";
}

/// A server keeps one file. Failing to look is no failure of the import.
void tell_of_materials(const std::string& file) {
  const auto format = mesh_format_of_path(file);
  if (!format.is_ok()) return;
  const auto named = names_material_files({file, *format, file});
  if (named.is_ok() && *named)
    std::cout << "the files that " << file
              << " names (mtllib) stay where they are; an exported .obj names them again\n";
}

Status run(const ImportOptions& options) {
  ASSIGN_OR_RETURN(Connection connection, options.server.connect());
  const std::string name =
      options.name.empty() ? std::filesystem::path(options.file).stem().string() : options.name;
  ProgressPrinter printer;
  auto outcome = connection.import_scan(options.file, name, options.key, printer.progress());
  if (!outcome.is_ok()) return outcome.status().with_context("import of " + options.file);
  if (!options.name.empty() && outcome->scan.name != options.name)
    std::cerr << "warning: the server has these bytes already; the scan keeps its name "
              << outcome->scan.name << ". To change it: burnish rename scan "
              << short_id(outcome->scan.id) << " '" << options.name << "'\n";
  if (!options.server.json) {
    print(*outcome);
    tell_of_materials(options.file);
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
  command->add_option("SCAN", options->file, "Mesh file: .ply, .obj, .stl or .off")->required();
  command->add_option("--name", options->name, "Its name there; left out: the file's");
  add_prepared_options(*command, options->key);
  add_server_options(*command, options->server);
}

}  // namespace burnish
