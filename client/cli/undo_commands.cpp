// Commands that change which entries of a session's history are on.

#include <algorithm>
#include <iostream>
#include <memory>

#include "client/cli/commands.h"
#include "client/cli/in_range.h"
#include "client/cli/json_output.h"
#include "client/cli/print_json.h"
#include "client/cli/server_option.h"
#include "common/edit/edit_id.h"

namespace burnish {

namespace {

struct UndoOptions {
  ServerOption server;
  std::string session;
  size_t steps = 1;
  std::string checkpoint;
  bool restore = false;
};

/// Prints in words what each edit changed.
Status print_outcome(Connection& connection, const UndoOptions& options, const char* done,
                     const std::vector<uint64_t>& numbers) {
  ASSIGN_OR_RETURN(const std::vector<HistoryEntry> history, connection.history(options.session));
  auto array = nlohmann::ordered_json::array();
  for (const uint64_t number : numbers) {
    const auto entry = std::find_if(history.begin(), history.end(),
                                    [&](const HistoryEntry& e) { return e.number == number; });
    if (entry == history.end()) continue;
    if (options.server.json) {
      array.push_back(to_json(*entry));
    } else {
      std::cout << done << " " << number << ": " << entry->summary << "\n";
    }
  }
  if (options.server.json) print_json(array);
  return Status::ok();
}

template <typename Change>
Status apply_steps(const UndoOptions& options, const Change& change, const char* done) {
  ASSIGN_OR_RETURN(Connection connection, options.server.connect());
  const std::vector<Edit> edits = make_edits_of(options.steps, change);
  ASSIGN_OR_RETURN(const ApplyOutcome outcome, connection.apply(options.session, edits));
  return print_outcome(connection, options, done, outcome.entries);
}

Status set_or_restore(const UndoOptions& options) {
  if (!options.restore) return apply_steps(options, SetCheckpoint{options.checkpoint}, "set");
  ASSIGN_OR_RETURN(Connection connection, options.server.connect());
  const std::vector<Edit> edits = make_edits_of(1, RestoreCheckpoint{options.checkpoint});
  RETURN_IF_ERROR(connection.apply(options.session, edits).status());
  if (options.server.json) {
    print_json({{"session", options.session}, {"restored", options.checkpoint}});
  } else {
    std::cout << "restored " << options.checkpoint << "\n";
  }
  return Status::ok();
}

void add_steps_option(CLI::App& command, UndoOptions& options, const char* description) {
  command.add_option("SESSION", options.session, "Name or id")->required();
  command.add_option("--steps", options.steps, description)
      ->check(in_range(size_t{1}, kEditsPerFrameMax))
      ->capture_default_str();
  add_server_options(command, options.server);
}

}  // namespace

void add_undo_command(CommandTable& table) {
  auto options = std::make_shared<UndoOptions>();
  CLI::App* command = table.add("undo", "Undo your last edits of a session; edits of others stay",
                                [=] { return apply_steps(*options, Undo{}, "undone"); });
  add_steps_option(*command, *options, "How many edits");
}

void add_redo_command(CommandTable& table) {
  auto options = std::make_shared<UndoOptions>();
  CLI::App* command = table.add("redo", "Redo the edits that you undid last",
                                [=] { return apply_steps(*options, Redo{}, "redone"); });
  add_steps_option(*command, *options, "How many edits");
}

void add_checkpoint_command(CommandTable& table) {
  auto options = std::make_shared<UndoOptions>();
  CLI::App* command = table.add("checkpoint", "Name a session's state, or go back to a named one",
                                [options] { return set_or_restore(*options); });
  command->add_option("SESSION", options->session, "Name or id")->required();
  command->add_option("NAME", options->checkpoint, "The state's name")->required();
  command->add_flag("--restore", options->restore, "Go back to it; the history stays");
  add_server_options(*command, options->server);
}

}  // namespace burnish
