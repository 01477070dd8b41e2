#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "client/connection/connection.h"

namespace burnish {

// The files that go to a server and come from it. scan_files.cpp has them on the disk; in a browser
// (client/web/core/host/scan_files.cpp) a path is the name of a file that the page has given or
// that the user will get.

/// Uploads a file. `missing`: names of files that the mesh names and that are not there. Fails: as
/// Connection::import_scan().
Result<ImportOutcome> import_file(Connection& connection, const std::filesystem::path& file,
                                  int depth, std::vector<std::string>& missing,
                                  const Progress& progress);

/// Checks before long work that a file can be written. Fails: as export_target().
Status check_export(const std::filesystem::path& file);

/// Solves on the server and writes the edited scan to `file`, with records of who did what beside
/// it if the wish is for a deviation. Fails: as export_files().
Result<ExportSummary> export_to_file(Connection& connection, const SessionInfo& session,
                                     const ExportWish& wish, const std::filesystem::path& file,
                                     const Progress& progress);

}  // namespace burnish
