#include "server/rpc/calls/fetch_calls.h"

#include "common/wire/pages_wire.h"
#include "common/wire/sheets_wire.h"

namespace burnish {

FetchPagesCall::FetchPagesCall(const CallContext& calls, const v1::FetchPagesRequest& request)
    : calls_(calls),
      request_(request),
      events_([this](const v1::FetchPagesEvent* event) { StartWrite(event); },
              [this](grpc::Status status) { Finish(std::move(status)); }) {}

void FetchPagesCall::begin() {
  calls_.executor.post([call = self()] { call->end(call->send()); },
                       [call = self()](const Status& status) { call->end(status); });
}

// A request has few parts, so all of them may wait in the queue.
Status FetchPagesCall::send() {
  ASSIGN_OR_RETURN(const PagesWish wish, from_wire(request_));
  ASSIGN_OR_RETURN(const ScanInfo scan, calls_.store.find(wish.scan));
  const Progress progress = [this](std::string_view, double) { return !cancelled_; };
  const auto send_block = [this](const PagePart& part) {
    v1::FetchPagesEvent event;
    *event.mutable_block() = to_wire(part);
    events_.push(std::move(event));
  };
  const auto send_page = [this](const PagePart& part) {
    v1::FetchPagesEvent event;
    *event.mutable_page() = to_wire(part);
    events_.push(std::move(event));
  };
  return calls_.store.read_pages(scan.id, wish, {send_block, send_page}, progress);
}

FetchSheetsCall::FetchSheetsCall(const CallContext& calls, const v1::FetchSheetsRequest& request)
    : calls_(calls),
      request_(request),
      events_([this](const v1::FetchSheetsEvent* event) { StartWrite(event); },
              [this](grpc::Status status) { Finish(std::move(status)); }) {}

void FetchSheetsCall::begin() {
  calls_.executor.post([call = self()] { call->end(call->send()); },
                       [call = self()](const Status& status) { call->end(status); });
}

// A request has few parts, so all of them may wait in the queue.
Status FetchSheetsCall::send() {
  ASSIGN_OR_RETURN(const SheetsWish wish, from_wire(request_));
  ASSIGN_OR_RETURN(const ScanInfo scan, calls_.store.find(wish.scan));
  const Progress progress = [this](std::string_view, double) { return !cancelled_; };
  const auto send_block = [this](const PagePart& part) {
    v1::FetchSheetsEvent event;
    *event.mutable_block() = to_wire(part);
    events_.push(std::move(event));
  };
  const auto send_charts = [this](const PagePart& part) {
    v1::FetchSheetsEvent event;
    *event.mutable_charts() = to_wire(part);
    events_.push(std::move(event));
  };
  const auto send_sheet = [this](const SheetPart& part) {
    v1::FetchSheetsEvent event;
    *event.mutable_sheet() = to_wire(part);
    events_.push(std::move(event));
  };
  return calls_.store.read_sheets(scan.id, wish, {send_block, send_charts, send_sheet}, progress);
}

}  // namespace burnish
