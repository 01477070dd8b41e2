#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "client/connection/connection.h"

namespace burnish {

/// The story of a scan until an export: who did what, when, with which parameters, how far the
/// surface moved, and the hashes of both files.
struct ProcessingRecord {
  std::string program;  ///< "burnish 0.1.0"
  int64_t unix_ms = 0;  ///< when the export was made
  std::string author;   ///< who exported; empty: unnamed
  ScanInfo scan;        ///< its id is the hash of the imported file
  PreparedDescription prepared;
  SessionState state;
  std::vector<HistoryEntry> edits;  ///< up to the export, those that were switched off too
  bool is_edited_since = false;     ///< entries may have been switched after the export
  std::string file;                 ///< name of the exported file, without folders
  ExportSummary result;             ///< with its deviation
};

/// Who exported, and into which file.
struct RecordedExport {
  std::string author;
  std::filesystem::path file;
  ExportSummary result;
};

/// Asks the server for the rest of the record. Needs: an export with its deviation. Fails: as the
/// server says.
Result<ProcessingRecord> make_processing_record(Connection& connection, const std::string& session,
                                                const RecordedExport& made);

/// Returns the record for programs: one JSON object.
std::string record_json(const ProcessingRecord& record);

/// Returns the record for people: a page of HTML that prints well and needs nothing else.
std::string record_page(const ProcessingRecord& record);

/// Writes the record: as a page to a file that ends in .html, else as JSON. Fails: as writing does.
Status write_record(const ProcessingRecord& record, const std::filesystem::path& file);

/// Writes STEM-record.html and STEM-record.json beside the exported file STEM.ply. Fails: as the
/// server says; as writing does.
Status write_records(Connection& connection, const std::string& session,
                     const RecordedExport& made);

/// Returns whether a record is written to such a file: it ends in .json or .html. Fails:
/// invalid_argument that names the choices.
Status check_record_name(const std::filesystem::path& file);

}  // namespace burnish
