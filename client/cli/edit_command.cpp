#include <iostream>
#include <memory>

#include "client/cli/cell_field_file.h"
#include "client/cli/commands.h"
#include "client/cli/controls_options.h"
#include "client/cli/filter_choice.h"
#include "client/cli/print_json.h"
#include "client/cli/server_option.h"
#include "client/cli/stroke_file.h"
#include "common/edit/edit_id.h"

namespace burnish {

namespace {

struct EditOptions {
  ServerOption server;
  std::string session;
  FilterChoice filter;
  std::string stroke_file;
  std::string cell_field_file;
  ControlsOptions controls;
  std::string id;
};

/// The facts of a session that some edits need.
struct EditedSession {
  ScanLengths lengths;
  Settings settings;
  uint64_t edits = 0;
};

/// Asks the scan's own noise, if the user leaves it to that, and says the answer.
Status propose(const std::string& scan, FilterChoice& choice, Connection& connection) {
  if (!choice.asks_for_noise()) return Status::ok();
  ASSIGN_OR_RETURN(const EdgeProposal proposal, connection.propose_edges(scan, {}));
  std::cerr << choice.take(proposal);
  return Status::ok();
}

/// Asks only for what these edits need.
Result<EditedSession> look_at(EditOptions& options, Connection& connection) {
  EditedSession there;
  const FilterChoice& filter = options.filter;
  if (!options.controls.is_given() && !filter.needs_settings() && !filter.needs_scan())
    return there;
  ASSIGN_OR_RETURN(const SessionState state, connection.state(options.session));
  there.settings = state.settings;
  there.edits = state.session.edits;
  if (!filter.needs_scan()) return there;
  const SessionInfo& session = state.session;
  ASSIGN_OR_RETURN(const ScanDescription scan,
                   connection.describe_scan(session.scan_id, session.key.depth));
  if (!scan.prepared)
    return failed_precondition("scan " + scan.scan.name + " is not prepared at depth " +
                               std::to_string(session.key.depth));
  RETURN_IF_ERROR(propose(session.scan_id, options.filter, connection));
  const bool keeps_volume = options.controls.over(there.settings.controls).keep_volume;
  there.lengths = {scan.prepared->length_unit,
                   scan.prepared->cell_size,
                   scan.scan.statistics.mean_edge_length,
                   sharp_bend_of(scan.prepared->histogram_range, scan.prepared->histogram),
                   filter.noise,
                   !keeps_volume && filter.equaliser.bands.empty()};
  std::cerr << told_preset(filter, there.lengths);
  return there;
}

/// Makes the edits in the order of application: metric, gradient scale, paint, cells, controls.
Result<std::vector<Edit>> make_edits(const EditOptions& options, const EditedSession& there) {
  std::vector<Edit> edits;
  const std::string prefix = options.id.empty() ? random_id() : options.id;
  const auto add = [&](auto change) {
    edits.push_back({prefix + "-" + std::to_string(edits.size()), std::move(change)});
  };
  ASSIGN_OR_RETURN(auto changes, changes_of(options.filter, there.lengths, there.settings));
  for (auto& change : changes) add(std::move(change));
  if (!options.stroke_file.empty()) {
    ASSIGN_OR_RETURN(std::vector<Stroke> strokes, read_stroke_file(options.stroke_file));
    for (Stroke& stroke : strokes) add(std::move(stroke));
  }
  if (!options.cell_field_file.empty()) {
    ASSIGN_OR_RETURN(SetCellFields fields, read_cell_field_file(options.cell_field_file));
    add(std::move(fields));
  }
  if (options.controls.is_given()) add(SetControls{options.controls.over(there.settings.controls)});
  return edits;
}

Result<ApplyOutcome> apply(const EditOptions& options, const EditedSession& there,
                           Connection& connection) {
  ASSIGN_OR_RETURN(const std::vector<Edit> edits, make_edits(options, there));
  if (edits.empty()) return ApplyOutcome{.edits = there.edits};
  return connection.apply(options.session, edits);
}

Status run(EditOptions options) {
  ASSIGN_OR_RETURN(Connection connection, options.server.connect());
  ASSIGN_OR_RETURN(const EditedSession there, look_at(options, connection));
  ASSIGN_OR_RETURN(const ApplyOutcome outcome, apply(options, there, connection));
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
  add_filter_options(*changes, options.filter);
  add_edge_options(*changes, options.filter);
  changes->add_option(
      "--stroke", options.stroke_file,
      "File of strokes: 'brush RADIUS STRENGTH BETA FALLOFF [band:N|curve:N|colour|edges|texture] "
      "[through]', then 'X Y Z' lines; 'through' paints through thin walls");
  changes->add_option("--cell-field", options.cell_field_file,
                      "File of cells: 'i j k alpha1 alpha2 beta' lines");
  add_controls_options(*changes, options.controls);
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
