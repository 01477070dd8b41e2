#include <cstring>

#include "client/connection/connection_state.h"
#include "common/transfer/chunk.h"
#include "common/wire/library_wire.h"
#include "common/wire/session_wire.h"

namespace burnish {
namespace {

/// Bytes that come in chunks, each one checked; memory is taken as they come.
class Arriving {
 public:
  Status append(const v1::Chunk& chunk) {
    RETURN_IF_ERROR(check_chunk(bytes_.size(), chunk.offset(), chunk.data(), chunk.crc32()));
    if (bytes_.size() + chunk.data().size() > kViewMemoryBytesMax)
      return resource_exhausted("the server sends more than " +
                                std::to_string(kViewMemoryBytesMax) + " bytes");
    bytes_.insert(bytes_.end(), chunk.data().begin(), chunk.data().end());
    return Status::ok();
  }

  const std::vector<uint8_t>& bytes() const { return bytes_; }

 private:
  std::vector<uint8_t> bytes_;
};

bool report_arrived(const Progress& progress, uint64_t bytes, uint64_t all) {
  return report(progress, "fetching the view",
                all == 0 ? 0 : std::min(1.0, double(bytes) / double(all)));
}

}  // namespace

Result<View> Connection::fetch_view(const ViewWish& wish, const Progress& progress) {
  grpc::ClientContext context;
  const auto reader = state_->library->FetchView(&context, to_wire(wish));
  v1::FetchViewEvent event;
  Arriving view;
  uint64_t size_bytes = 0;
  Status here;  // what went wrong on this side
  const auto wanted = [&](bool go_on) {
    if (!go_on) here = cancelled("fetching the view was cancelled");
  };
  while (reader->Read(&event)) {
    if (event.has_progress())
      wanted(report(progress, event.progress().phase(), event.progress().fraction()));
    if (event.has_header()) size_bytes = event.header().size_bytes();
    if (event.has_chunk()) {
      here = view.append(event.chunk());
      if (here.is_ok()) wanted(report_arrived(progress, view.bytes().size(), size_bytes));
    }
    if (here.is_ok()) continue;
    context.TryCancel();
    break;
  }
  while (reader->Read(&event)) {
  }
  const grpc::Status there = reader->Finish();
  RETURN_IF_ERROR(here);
  RETURN_IF_ERROR(call_status(server(), there));
  auto read = read_view(view.bytes());
  if (!read.is_ok()) return read.status().with_context("server " + server());
  return read;
}

Result<std::vector<float>> Connection::cells(const std::string& session, CellValue value) {
  grpc::ClientContext context;
  v1::GetCellsRequest request;
  request.set_session(session);
  request.set_value(to_wire(value));
  const auto reader = state_->editing->GetCells(&context, request);
  v1::Chunk chunk;
  Arriving cells;
  Status here;
  while (reader->Read(&chunk)) {
    if (here.is_ok()) here = cells.append(chunk);
    if (!here.is_ok()) context.TryCancel();
  }
  const grpc::Status there = reader->Finish();
  RETURN_IF_ERROR(here);
  RETURN_IF_ERROR(call_status(server(), there));
  std::vector<float> values(cells.bytes().size() / sizeof(float));
  std::memcpy(values.data(), cells.bytes().data(), values.size() * sizeof(float));
  return values;
}

}  // namespace burnish
