#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "client/cli/controls_options.h"
#include "client/cli/filter_choice.h"
#include "client/cli/progress_printer.h"
#include "server/prepare/prepare.h"
#include "server/session/session.h"

namespace burnish {

/// The options of `burnish filter`.
struct FilterOptions {
  std::vector<std::string> files;  ///< IN and OUT, or with a folder all IN
  std::string out_dir;             ///< empty: none
  std::string from = "ply";        ///< format of standard input
  std::string to;                  ///< format in the folder, or of standard output; empty: IN's
  bool force = false;
  bool no_clobber = false;
  bool update = false;  ///< skip each OUT that is newer than its IN
  bool json = false;
  bool reports = false;  ///< one beside each file that is written
  bool depths = false;
  ProgressStyle progress = ProgressStyle::kText;
  PrepareOptions prepare;
  SolverOptions solver;
  SolveOptions solve;
  FilterChoice filter;
  ControlsOptions controls;
  std::string paint_file, cell_field_file, fields_file, report_file;
};

/// Adds the files, the filter and how it is solved to a command.
void add_run_options(CLI::App& command, FilterOptions& options);
/// Adds the filter and how it is solved alone.
void add_work_options(CLI::App& command, FilterOptions& options);

}  // namespace burnish
