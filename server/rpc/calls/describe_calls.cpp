#include "server/rpc/calls/describe_calls.h"

#include "common/wire/pages_wire.h"
#include "common/wire/sheets_wire.h"

namespace burnish {

Status DescribePagesCall::run() {
  ASSIGN_OR_RETURN(const ScanInfo scan, calls_.store.find(request_.scan()));
  ASSIGN_OR_RETURN(const PagesDescription description,
                   calls_.store.describe_pages(scan.id, progress(), calls_.user));
  v1::DescribePagesEvent event;
  *event.mutable_done() = to_wire(description);
  events_.push(std::move(event));
  return Status::ok();
}

Status DescribeSheetsCall::run() {
  ASSIGN_OR_RETURN(const ScanInfo scan, calls_.store.find(request_.scan()));
  SeamLevelling seams;
  if (request_.has_session()) {
    ASSIGN_OR_RETURN(seams,
                     calls_.sessions.seams(request_.session(), scan.id, calls_.caller, progress()));
  }
  ASSIGN_OR_RETURN(
      const SheetsDescription description,
      calls_.store.describe_sheets(scan.id, progress(), {seams.amount, seams.free}, calls_.user));
  v1::DescribeSheetsEvent event;
  *event.mutable_done() = to_wire(description);
  events_.push(std::move(event));
  return Status::ok();
}

}  // namespace burnish
