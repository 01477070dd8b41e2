#include <optional>
#include <utility>

#include "client/connection/connection_state.h"
#include "common/base/atomic_file.h"
#include "common/transfer/chunk.h"
#include "common/transfer/content_hash.h"
#include "common/wire/session_wire.h"

namespace burnish {
namespace {

/// The file as it arrives: every piece checked, and the whole against the summary.
class Download {
 public:
  static Result<Download> create(const std::filesystem::path& path) {
    ASSIGN_OR_RETURN(AtomicFile file, AtomicFile::create(path));
    return Download(std::move(file));
  }

  Status append(const v1::Chunk& chunk) {
    RETURN_IF_ERROR(check_chunk(received_bytes_, chunk.offset(), chunk.data(), chunk.crc32()));
    RETURN_IF_ERROR(file_.write(chunk.data()));
    hash_.update(chunk.data());
    received_bytes_ += chunk.data().size();
    return Status::ok();
  }

  Status finish(const ExportSummary& summary) {
    if (received_bytes_ != summary.size_bytes || hash_.finish() != summary.sha256)
      return data_loss("the exported mesh was damaged on its way");
    return file_.commit();
  }

 private:
  explicit Download(AtomicFile file) : file_(std::move(file)) {}

  AtomicFile file_;
  ContentHash hash_;
  uint64_t received_bytes_ = 0;
};

Status take_summary(const v1::ExportSummary& message, ExportSummary& summary) {
  ASSIGN_OR_RETURN(summary, from_wire(message));
  return Status::ok();
}

}  // namespace

Result<ExportSummary> Connection::export_mesh(const std::string& session, const ExportWish& wish,
                                              const std::filesystem::path& path,
                                              const Progress& progress) {
  std::optional<Download> download;
  ExportSummary summary;
  Status here;  // what went wrong on this side
  const auto take = [&](const v1::ExportEvent& event) {
    if (event.has_summary() && here.is_ok()) here = take_summary(event.summary(), summary);
    if (event.has_chunk() && here.is_ok()) here = download->append(event.chunk());
    if (event.has_progress() &&
        !report(progress, event.progress().phase(), event.progress().fraction()))
      here = cancelled("the export was cancelled");
  };
  const Status there =
      state_->call_owner([&](v1::Editing::Stub& owner, grpc::ClientContext& context) {
        // Nothing stays of a call that another server goes on with.
        auto begun = Download::create(path);
        here = begun.status();
        if (!here.is_ok()) return grpc::Status();
        download.emplace(std::move(begun).value());
        const auto reader = owner.Export(&context, to_wire(session, wish));
        v1::ExportEvent event;
        while (reader->Read(&event)) {
          take(event);
          if (!here.is_ok()) context.TryCancel();
        }
        return reader->Finish();
      });
  RETURN_IF_ERROR(here);
  RETURN_IF_ERROR(there);
  RETURN_IF_ERROR(download->finish(summary));
  return summary;
}

}  // namespace burnish
