#include "client/connection/sheet_calls.h"

#include <optional>
#include <utility>

#include "client/connection/event_stream.h"
#include "common/wire/pages_wire.h"
#include "common/wire/sheets_wire.h"

namespace burnish {

static constexpr const char* kDescribing = "describing the sheets";

/// Asks the server that has the session.
template <typename State>
static Result<SheetsDescription> describe_levelled(State& state, v1::DescribeSheetsRequest request,
                                                   const std::string& session,
                                                   const Progress& progress) {
  request.set_session(session);
  std::optional<v1::SheetsDescription> done;
  bool is_heard = true;
  RETURN_IF_ERROR(state.call_reached([&](const ReachedServer& owner, grpc::ClientContext& context) {
    const auto reader = owner.library->DescribeSheets(&context, request);
    is_heard = read_events<v1::DescribeSheetsEvent>(context, *reader, progress, done);
    const grpc::Status ended = reader->Finish();
    return is_heard ? ended : grpc::Status();
  }));
  if (!is_heard) return cancelled(std::string(kDescribing) + " was cancelled");
  if (!done) return data_loss(std::string("a server ended ") + kDescribing + " without an answer");
  return from_wire(*done);
}

Result<SheetsDescription> Connection::describe_sheets(const std::string& scan,
                                                      const Progress& progress,
                                                      const std::string& session) {
  v1::DescribeSheetsRequest request;
  request.set_scan(scan);
  if (!session.empty()) return describe_levelled(*state_, std::move(request), session, progress);
  grpc::ClientContext context;
  const auto reader = state_->library->DescribeSheets(&context, request);
  ASSIGN_OR_RETURN(const auto done, read_until_done<v1::DescribeSheetsEvent>(
                                        server(), context, *reader, progress, kDescribing));
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
  if (wish.version == 0) return fetch_sheet_parts(server(), *state_->library, context, wish, take);
  ASSIGN_OR_RETURN(const auto owner, state_->reach());
  set_node(context, owner->place.node);
  return fetch_sheet_parts(owner->place.address, *owner->library, context, wish, take);
}

}  // namespace burnish
