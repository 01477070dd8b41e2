// client/model/files/scan_files.h where files come from the page and go to the user.

#include "client/model/files/scan_files.h"

#include <algorithm>

#include "client/report/processing_record.h"
#include "client/web/core/host/page_files.h"
#include "client/web/core/host/stacks.h"

namespace burnish {

namespace {

/// Reads a file of the page part by part. It lets others run now and then.
class PageFileSource final : public ScanSource {
 public:
  PageFileSource(const PageFile& file, MeshFormat format) : file_(file), format_(format) {}

  MeshFormat format() const override { return format_; }
  uint64_t size_bytes() const override { return file_.size_bytes; }
  Result<std::string_view> read(uint64_t offset, size_t bytes) override {
    give_a_turn(bytes);
    part_ = read_page_file(file_, offset, bytes);
    if (part_.size() == bytes) return std::string_view(part_);
    return unavailable("the browser cannot read the file at byte " + std::to_string(offset) +
                       ": it has changed or is gone");
  }

 private:
  void give_a_turn(size_t bytes) {
    static constexpr size_t kBytesPerTurn = 4 << 20;
    read_ += bytes;
    if (read_ < kBytesPerTurn) return;
    read_ = 0;
    resume_stack(this_stack());
    wait_on_stack();
  }

  const PageFile file_;
  const MeshFormat format_;
  std::string part_;
  size_t read_ = 0;  // since the last turn
};

}  // namespace

Result<ImportOutcome> import_file(Connection& connection, const std::filesystem::path& file,
                                  int depth, std::vector<std::string>&, const Progress& progress) {
  ASSIGN_OR_RETURN(const MeshFormat format, mesh_format_of_path(file));
  const auto given = find_page_file(file.string());
  if (!given) return not_found("nobody has given the page a file '" + file.string() + "'");
  if (given->size_bytes == 0)
    return invalid_argument(file.string() + ": the file is empty (0 bytes)");
  PageFileSource source(*given, format);
  return connection.import_scan(source, file.stem().string(), {depth, 0}, progress);
}

Status check_export(const std::filesystem::path& file) {
  return written_format_of_path(file).status();
}

// The server writes the format that is asked for, as it can for this scan.
Result<ExportSummary> export_to_file(Connection& connection, const SessionInfo& session,
                                     const ExportWish& wish, const std::filesystem::path& file,
                                     const Progress& progress) {
  ExportWish asked = wish;
  ASSIGN_OR_RETURN(asked.format, written_format_of_path(file));
  ASSIGN_OR_RETURN(const ExportSummary summary,
                   connection.export_mesh(session.id, asked, file, progress));
  const RecordedExport made{connection.user(), file, summary};
  if (wish.deviation)
    RETURN_IF_ERROR(write_records(connection, session.id, made).with_context("record"));
  return summary;
}

}  // namespace burnish
