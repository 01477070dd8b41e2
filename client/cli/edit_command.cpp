#include <iostream>
#include <memory>
#include <optional>

#include "client/cli/cell_field_file.h"
#include "client/cli/commands.h"
#include "client/cli/json_output.h"
#include "client/cli/server_option.h"
#include "client/cli/stroke_file.h"
#include "common/edit/edit_id.h"

namespace burnish {

namespace {

struct EditOptions {
  ServerOption server;
  std::string session;
  std::optional<double> beta;
  std::optional<double> alpha;
  std::string curve;
  std::string stroke_file;
  std::string cell_field_file;
  std::string id;
};

/// Makes the edits in the order of application: metric, gradient scale, paint, cells.
Result<std::vector<Edit>> make_edits(const EditOptions& options) {
  std::vector<Edit> edits;
  const std::string prefix = options.id.empty() ? random_id() : options.id;
  const auto add = [&](auto change) {
    edits.push_back({prefix + "-" + std::to_string(edits.size()), std::move(change)});
  };
  if (options.alpha) add(SetTransferCurve{TransferCurve(*options.alpha)});
  if (!options.curve.empty()) {
    ASSIGN_OR_RETURN(TransferCurve curve, TransferCurve::parse(options.curve));
    add(SetTransferCurve{std::move(curve)});
  }
  if (options.beta) add(SetGradientScale{*options.beta});
  if (!options.stroke_file.empty()) {
    ASSIGN_OR_RETURN(std::vector<Stroke> strokes, read_stroke_file(options.stroke_file));
    for (Stroke& stroke : strokes) add(std::move(stroke));
  }
  if (!options.cell_field_file.empty()) {
    ASSIGN_OR_RETURN(SetCellFields fields, read_cell_field_file(options.cell_field_file));
    add(std::move(fields));
  }
  return edits;
}

Status run(const EditOptions& options) {
  ASSIGN_OR_RETURN(const std::vector<Edit> edits, make_edits(options));
  ASSIGN_OR_RETURN(Connection connection, options.server.connect());
  ASSIGN_OR_RETURN(const ApplyOutcome outcome, connection.apply(options.session, edits));
  if (options.server.json) {
    print_json({{"applied", outcome.applied}, {"known", outcome.known}, {"edits", outcome.edits}});
    return Status::ok();
  }
  std::cout << options.session << ": " << outcome.applied
            << (outcome.applied == 1 ? " edit applied" : " edits applied");
  if (outcome.known > 0) std::cout << ", " << outcome.known << " already known";
  std::cout << ", " << outcome.edits << " in all\n";
  return Status::ok();
}

void add_change_options(CLI::App& command, EditOptions& options) {
  CLI::Option_group* changes = command.add_option_group("Changes", "At least one of them");
  changes->require_option(1, 0);
  changes->add_option("--beta", options.beta, "Gradient scale: < 1 smooths, 1 keeps, > 1 sharpens")
      ->check(CLI::Range(kBetaMin, kBetaMax));
  CLI::Option* alpha =
      changes->add_option("--alpha", options.alpha, "Fidelity weight, the same everywhere")
          ->check(CLI::Range(kAlphaMin, kAlphaMax));
  changes->add_option("--curve", options.curve, "Transfer curve: alpha by curvature")
      ->type_name("K:A,K:A,...")
      ->check([](const std::string& text) {
        return usage_message(TransferCurve::parse(text).status());
      })
      ->excludes(alpha);
  changes->add_option("--stroke", options.stroke_file,
                      "File of strokes: 'brush RADIUS STRENGTH BETA FALLOFF', then 'X Y Z' lines");
  changes->add_option("--cell-field", options.cell_field_file,
                      "File of cells: 'i j k alpha1 alpha2 beta' lines");
}

}  // namespace

void add_edit_command(CommandTable& table) {
  auto options = std::make_shared<EditOptions>();
  CLI::App* command = table.add("edit", "Change a session", [options] { return run(*options); });
  command->add_option("SESSION", options->session, "Name or id")->required();
  add_change_options(*command, *options);
  command->add_option("--id", options->id,
                      "Id of this change: sending it twice under one id is harmless");
  add_server_options(*command, options->server);
}

}  // namespace burnish
