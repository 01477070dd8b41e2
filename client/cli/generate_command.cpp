#include <iostream>
#include <memory>

#include "client/cli/commands.h"
#include "client/cli/in_range.h"
#include "client/cli/print_json.h"
#include "common/generate/generate.h"
#include "common/mesh/io/mesh_io.h"

namespace burnish {

namespace {

struct GenerateOptions {
  GeneratedScan scan;
  std::string noise_kind = "range";
  std::string out;
  bool json = false;
};

Status run(const GenerateOptions& options) {
  GeneratedScan scan = options.scan;
  ASSIGN_OR_RETURN(scan.noise_kind, parse_noise_kind(options.noise_kind));
  ASSIGN_OR_RETURN(const TriangleMesh mesh, generate_scan(scan));
  RETURN_IF_ERROR(write_mesh(mesh, options.out));
  if (options.json) {
    print_json({{"out", options.out},
                {"vertices", mesh.vertices.size()},
                {"triangles", mesh.triangles.size()}});
    return Status::ok();
  }
  std::cout << options.out << ": " << mesh.vertices.size() << " vertices, " << mesh.triangles.size()
            << " triangles\n";
  return Status::ok();
}

}  // namespace

void add_generate_command(CommandTable& table) {
  auto options = std::make_shared<GenerateOptions>();
  CLI::App* command =
      table.add("generate", "Write a generated scan", [options] { return run(*options); });
  std::string kinds = "Kinds:";
  std::vector<std::string> names;
  for (const GeneratedScanKind& kind : generated_scan_kinds()) {
    names.emplace_back(kind.name);
    kinds += "\n  " + std::string(kind.name) + ": " + std::string(kind.description);
  }
  command->add_option("KIND", options->scan.kind, "What to make")
      ->required()
      ->check(CLI::IsMember(names));
  command->add_option("OUT", options->out, "File to write: .ply, .obj, .stl or .glb")->required();
  command->add_option("--vertices", options->scan.vertices, "About how many")
      ->capture_default_str();
  command->add_option("--seed", options->scan.seed, "Same seed, same scan")->capture_default_str();
  CLI::Option* noise =
      command
          ->add_option(
              "--noise", options->scan.noise,
              "Deviation of the scanner's noise, over the mean edge, along the normals; 0: none "
              "(default: what the kind has by itself)")
          ->check(in_range(0.0, kScannerNoiseMax));
  command
      ->add_option("--noise-kind", options->noise_kind,
                   "range: half of it is smooth over two edges; gauss: of each vertex's own; "
                   "scanner: structured light, alike over three edges, with steps of depth of "
                   "twice the deviation")
      ->check(CLI::IsMember({"range", "gauss", "scanner"}))
      ->capture_default_str()
      ->needs(noise);
  command->add_flag("--json", options->json, "Print the result as JSON");
  command->footer(kinds);
}

}  // namespace burnish
