#include "client/model/files/scan_files.h"

#include "client/connection/export_files.h"
#include "client/report/processing_record.h"
#include "common/bundle/scan_bundle.h"

namespace burnish {

Result<ImportOutcome> import_file(Connection& connection, const std::filesystem::path& file,
                                  int depth, std::vector<std::string>& missing,
                                  const Progress& progress) {
  ASSIGN_OR_RETURN(const ScanBundle bundle, ScanBundle::open(file));
  missing = bundle.missing();
  return connection.import_scan(bundle, bundle.mesh().stem().string(), {depth, 0}, progress);
}

Status check_export(const std::filesystem::path& file) {
  return export_target(file, false).status();
}

Result<ExportSummary> export_to_file(Connection& connection, const SessionInfo& session,
                                     const ExportWish& wish, const std::filesystem::path& file,
                                     const Progress& progress) {
  ASSIGN_OR_RETURN(const ExportTarget target, export_target(file, false));
  ASSIGN_OR_RETURN(const ExportedFiles exported,
                   export_files(connection, session.id, wish, target, progress));
  const RecordedExport made{connection.user(), exported.mesh, exported.summary};
  if (wish.deviation)
    RETURN_IF_ERROR(write_records(connection, session.id, made).with_context("record"));
  return exported.summary;
}

}  // namespace burnish
