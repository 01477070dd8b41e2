#include "client/connection/sheet_calls.h"

#include <optional>

#include "client/connection/connection_state.h"
#include "common/wire/pages_wire.h"
#include "common/wire/sheets_wire.h"

namespace burnish {

Result<SheetsDescription> Connection::describe_sheets(const std::string& scan,
                                                      const Progress& progress) {
  grpc::ClientContext context;
  v1::DescribeSheetsRequest request;
  request.set_scan(scan);
  const auto reader = state_->library->DescribeSheets(&context, request);
  v1::DescribeSheetsEvent event;
  std::optional<SheetsDescription> description;
  bool is_cancelled = false;
  while (reader->Read(&event)) {
    if (event.has_done()) description = from_wire(event.done());
    if (is_cancelled || !event.has_progress()) continue;
    is_cancelled = !report(progress, event.progress().phase(), event.progress().fraction());
    if (is_cancelled) context.TryCancel();
  }
  const grpc::Status there = reader->Finish();
  if (is_cancelled) return cancelled("describing the sheets was cancelled");
  RETURN_IF_ERROR(call_status(server(), there));
  if (!description) return data_loss("server " + server() + " sent no description of sheets");
  return std::move(*description);
}

Status fetch_sheet_parts(const std::string& server, v1::Library::Stub& library,
                         grpc::ClientContext& context, const SheetsWish& wish,
                         const Connection::SheetTaker& take) {
  const auto reader = library.FetchSheets(&context, to_wire(wish));
  v1::FetchSheetsEvent event;
  bool is_wanted = true;
  while (reader->Read(&event)) {
    if (!is_wanted) continue;
    if (event.has_block()) is_wanted = take.block(from_wire(event.block()));
    if (event.has_charts()) is_wanted = take.charts(from_wire(event.charts()));
    if (event.has_sheet()) is_wanted = take.sheet(from_wire(event.sheet()));
    if (!is_wanted) context.TryCancel();
  }
  const grpc::Status there = reader->Finish();
  if (!is_wanted) return cancelled("fetching sheets was cancelled");
  return call_status(server, there);
}

Status Connection::fetch_sheets(const SheetsWish& wish, const SheetTaker& take) {
  grpc::ClientContext context;
  return fetch_sheet_parts(server(), *state_->library, context, wish, take);
}

}  // namespace burnish
