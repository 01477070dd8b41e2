#include <cstring>

#include "client/connection/connection_state.h"
#include "common/transfer/chunk.h"
#include "common/wire/session_wire.h"

namespace burnish {

static constexpr uint64_t kCellsBytesMax = uint64_t{16} << 30;

// Memory is taken as the bytes come.
static Status append_chunk(const v1::Chunk& chunk, std::vector<uint8_t>& bytes) {
  RETURN_IF_ERROR(check_chunk(bytes.size(), chunk.offset(), chunk.data(), chunk.crc32()));
  if (uint64_t{bytes.size()} + chunk.data().size() > kCellsBytesMax)
    return resource_exhausted("the server sends more than " + std::to_string(kCellsBytesMax) +
                              " bytes of cells");
  bytes.insert(bytes.end(), chunk.data().begin(), chunk.data().end());
  return Status::ok();
}

Result<std::vector<float>> Connection::cells(const std::string& session, CellValue value) {
  v1::GetCellsRequest request;
  request.set_session(session);
  request.set_value(to_wire(value));
  std::vector<uint8_t> cells;
  Status here;  // what went wrong on this side
  const Status there =
      state_->call_owner([&](v1::Editing::Stub& owner, grpc::ClientContext& context) {
        cells.clear();  // nothing stays of a call that another server goes on with
        const auto reader = owner.GetCells(&context, request);
        v1::Chunk chunk;
        while (reader->Read(&chunk)) {
          if (here.is_ok()) here = append_chunk(chunk, cells);
          if (!here.is_ok()) context.TryCancel();
        }
        return reader->Finish();
      });
  RETURN_IF_ERROR(here);
  RETURN_IF_ERROR(there);
  std::vector<float> values(cells.size() / sizeof(float));
  std::memcpy(values.data(), cells.data(), values.size() * sizeof(float));
  return values;
}

}  // namespace burnish
