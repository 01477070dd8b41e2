#include <algorithm>

#include "client/connection/connection_state.h"
#include "common/transfer/chunk.h"
#include "common/transfer/content_hash.h"
#include "common/wire/format_wire.h"
#include "common/wire/library_wire.h"

namespace burnish {
namespace {

using Stream = grpc::ClientReaderWriter<v1::ImportRequest, v1::ImportEvent>;

/// Reads events until the server wants the file, or has it. True: it wants it, from `offset` on.
bool wait_for_invitation(Stream& stream, const Progress& progress, v1::ImportDone& done,
                         uint64_t& offset) {
  v1::ImportEvent event;
  while (stream.Read(&event)) {
    if (event.has_received()) {
      offset = event.received().bytes();
      return true;
    }
    if (event.has_done()) done = event.done();
    if (event.has_progress())
      report(progress, event.progress().phase(), event.progress().fraction());
  }
  return false;
}

/// Sends the file until its end, the server's refusal, or a cancel. Fails: as reading does.
Status send_chunks(Stream& stream, grpc::ClientContext& context, ScanSource& scan, uint64_t offset,
                   const Progress& progress) {
  v1::ImportRequest request;
  while (offset < scan.size_bytes()) {
    auto piece = scan.read(offset, std::min<uint64_t>(kChunkBytes, scan.size_bytes() - offset));
    if (!piece.is_ok()) {
      context.TryCancel();
      return piece.status();
    }
    set_chunk(offset, *piece, *request.mutable_chunk());
    if (!stream.Write(request)) return Status::ok();
    offset += piece->size();
    if (!report(progress, "uploading", double(offset) / double(scan.size_bytes()))) {
      context.TryCancel();
      return Status::ok();
    }
  }
  return Status::ok();
}

void read_events(Stream& stream, grpc::ClientContext& context, const Progress& progress,
                 v1::ImportDone& done) {
  v1::ImportEvent event;
  while (stream.Read(&event)) {
    if (event.has_done()) done = event.done();
    if (event.has_progress() &&
        !report(progress, event.progress().phase(), event.progress().fraction()))
      context.TryCancel();
  }
}

Result<std::string> hash_of(ScanSource& scan) {
  ContentHash hash;
  for (uint64_t offset = 0; offset < scan.size_bytes();) {
    ASSIGN_OR_RETURN(
        const std::string_view piece,
        scan.read(offset, std::min<uint64_t>(kChunkBytes, scan.size_bytes() - offset)));
    hash.update(piece);
    offset += piece.size();
  }
  return hash.finish();
}

}  // namespace

Result<ImportOutcome> Connection::import_scan(ScanSource& scan, const std::string& name,
                                              const PreparedKey& key, const Progress& progress,
                                              bool exact_name) {
  ASSIGN_OR_RETURN(const std::string hash, hash_of(scan));
  const ImportHeader header{
      exact_name ? name : name_like(name), scan.format(), scan.size_bytes(), hash, key, exact_name};

  grpc::ClientContext context;
  const auto stream = state_->library->Import(&context);
  v1::ImportRequest request;
  *request.mutable_header() = to_wire(header);
  stream->Write(request);

  v1::ImportDone done;
  uint64_t offset = 0;
  Status here;  // what went wrong on this side
  if (wait_for_invitation(*stream, progress, done, offset))
    here = send_chunks(*stream, context, scan, offset, progress);
  stream->WritesDone();
  read_events(*stream, context, progress, done);
  const grpc::Status there = stream->Finish();
  RETURN_IF_ERROR(here);
  RETURN_IF_ERROR(call_status(server(), there));
  ImportOutcome outcome;
  ASSIGN_OR_RETURN(outcome.scan, from_wire(done.scan()));
  outcome.already_present = done.already_present();
  return outcome;
}

}  // namespace burnish
