#include "server/rpc/calls/fetch_calls.h"

#include "common/wire/pages_wire.h"
#include "common/wire/sheets_wire.h"

namespace burnish {

// A request has few parts, so all of them may wait in the queue.
Status FetchPagesCall::run() {
  ASSIGN_OR_RETURN(const PagesWish wish, from_wire(request_));
  ASSIGN_OR_RETURN(const ScanInfo scan, calls_.store.find(wish.scan));
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
  return calls_.store.read_pages(scan.id, wish, {send_block, send_page}, silent_progress());
}

// A request has few parts, so all of them may wait in the queue.
Status FetchSheetsCall::run() {
  ASSIGN_OR_RETURN(const SheetsWish wish, from_wire(request_));
  ASSIGN_OR_RETURN(const ScanInfo scan, calls_.store.find(wish.scan));
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
  return calls_.store.read_sheets(scan.id, wish, {send_block, send_charts, send_sheet},
                                  silent_progress());
}

}  // namespace burnish
