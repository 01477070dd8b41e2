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

/// Sends the file until its end, the server's refusal, or a cancel.
void send_chunks(Stream& stream, grpc::ClientContext& context, std::string_view bytes,
                 uint64_t offset, const Progress& progress) {
  v1::ImportRequest request;
  while (offset < bytes.size()) {
    const std::string_view piece = bytes.substr(offset, kChunkBytes);
    set_chunk(offset, piece, *request.mutable_chunk());
    if (!stream.Write(request)) return;
    offset += piece.size();
    if (!report(progress, "uploading", double(offset) / double(bytes.size()))) {
      context.TryCancel();
      return;
    }
  }
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

std::string hash_of(std::string_view bytes) {
  ContentHash hash;
  hash.update(bytes);
  return hash.finish();
}

}  // namespace

Result<ImportOutcome> Connection::import_scan(const std::filesystem::path& path,
                                              const std::string& name, const PreparedKey& key,
                                              const Progress& progress) {
  ASSIGN_OR_RETURN(const ScanBundle scan, ScanBundle::open(path));
  return import_scan(scan, name, key, progress);
}

Result<ImportOutcome> Connection::import_scan(const ScanBundle& scan, const std::string& name,
                                              const PreparedKey& key, const Progress& progress) {
  const std::string_view bytes(reinterpret_cast<const char*>(scan.bytes().data()),
                               scan.bytes().size());
  const ImportHeader header{name, scan.format(), bytes.size(), hash_of(bytes), key};

  grpc::ClientContext context;
  const auto stream = state_->library->Import(&context);
  v1::ImportRequest request;
  *request.mutable_header() = to_wire(header);
  stream->Write(request);

  v1::ImportDone done;
  uint64_t offset = 0;
  if (wait_for_invitation(*stream, progress, done, offset))
    send_chunks(*stream, context, bytes, offset, progress);
  stream->WritesDone();
  read_events(*stream, context, progress, done);
  RETURN_IF_ERROR(call_status(server(), stream->Finish()));
  ImportOutcome outcome;
  ASSIGN_OR_RETURN(outcome.scan, from_wire(done.scan()));
  outcome.already_present = done.already_present();
  return outcome;
}

}  // namespace burnish
