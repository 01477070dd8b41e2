#include "client/report/processing_record.h"

#include <algorithm>
#include <chrono>

#include "common/base/atomic_file.h"

namespace burnish {

static int64_t unix_ms_now() {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return std::chrono::duration_cast<std::chrono::milliseconds>(now).count();
}

Result<ProcessingRecord> make_processing_record(Connection& connection, const std::string& session,
                                                const RecordedExport& made) {
  ProcessingRecord record;
  record.program = "burnish " BURNISH_VERSION;
  record.unix_ms = unix_ms_now();
  record.author = made.author;
  record.file = made.file.filename().string();
  record.result = made.result;
  ASSIGN_OR_RETURN(record.state, connection.state(session));
  const SessionInfo& info = record.state.session;
  ASSIGN_OR_RETURN(const ScanDescription described,
                   connection.describe_scan(info.scan_id, info.key.depth));
  record.scan = described.scan;
  if (described.prepared) record.prepared = *described.prepared;
  ASSIGN_OR_RETURN(record.edits, connection.history(session));
  std::erase_if(record.edits,
                [&](const HistoryEntry& entry) { return entry.number > made.result.edits; });
  record.is_edited_since = info.edits > made.result.edits;
  return record;
}

Status check_record_name(const std::filesystem::path& file) {
  const std::string ending = file.extension().string();
  if (ending == ".json" || ending == ".html") return Status::ok();
  return invalid_argument("a record is written to .json or .html, not to " +
                          file.filename().string());
}

Status write_records(Connection& connection, const std::string& session,
                     const RecordedExport& made) {
  ASSIGN_OR_RETURN(const ProcessingRecord record,
                   make_processing_record(connection, session, made));
  const std::string stem = made.file.stem().string() + "-record";
  RETURN_IF_ERROR(write_record(record, made.file.parent_path() / (stem + ".json")));
  return write_record(record, made.file.parent_path() / (stem + ".html"));
}

Status write_record(const ProcessingRecord& record, const std::filesystem::path& file) {
  const bool is_page = file.extension() == ".html";
  return write_file(file, is_page ? record_page(record) : record_json(record));
}

}  // namespace burnish
