#include "client/connection/sheet_calls.h"

#include "client/connection/event_stream.h"
#include "common/wire/pages_wire.h"
#include "common/wire/sheets_wire.h"

namespace burnish {

Result<SheetsDescription> Connection::describe_sheets(const std::string& scan,
                                                      const Progress& progress) {
  grpc::ClientContext context;
  v1::DescribeSheetsRequest request;
  request.set_scan(scan);
  const auto reader = state_->library->DescribeSheets(&context, request);
  ASSIGN_OR_RETURN(const auto done,
                   read_until_done<v1::DescribeSheetsEvent>(server(), context, *reader, progress,
                                                            "describing the sheets"));
  return from_wire(done);
}

Status fetch_sheet_parts(const std::string& server, v1::Library::Stub& library,
                         grpc::ClientContext& context, const SheetsWish& wish,
                         const Connection::SheetTaker& take) {
  const auto reader = library.FetchSheets(&context, to_wire(wish));
  return read_while_wanted<v1::FetchSheetsEvent>(server, context, *reader, "fetching sheets",
                                                 [&](const v1::FetchSheetsEvent& event) {
                                                   if (event.has_block())
                                                     return take.block(from_wire(event.block()));
                                                   if (event.has_charts())
                                                     return take.charts(from_wire(event.charts()));
                                                   if (event.has_sheet())
                                                     return take.sheet(from_wire(event.sheet()));
                                                   return true;
                                                 });
}

Status Connection::fetch_sheets(const SheetsWish& wish, const SheetTaker& take) {
  grpc::ClientContext context;
  return fetch_sheet_parts(server(), *state_->library, context, wish, take);
}

}  // namespace burnish
