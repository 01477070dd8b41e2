#include "server/rpc/calls/describe_calls.h"

#include "common/wire/pages_wire.h"
#include "common/wire/sheets_wire.h"

namespace burnish {

DescribePagesCall::DescribePagesCall(const CallContext& calls,
                                     const v1::DescribePagesRequest& request)
    : calls_(calls),
      request_(request),
      events_([this](const v1::DescribePagesEvent* event) { StartWrite(event); },
              [this](grpc::Status status) { Finish(std::move(status)); }) {}

void DescribePagesCall::begin() {
  calls_.executor.post([call = self()] { call->end(call->describe()); },
                       [call = self()](const Status& status) { call->end(status); });
}

Status DescribePagesCall::describe() {
  ASSIGN_OR_RETURN(const ScanInfo scan, calls_.store.find(request_.scan()));
  const Progress progress = [this](std::string_view phase, double fraction) {
    return report_progress(phase, fraction);
  };
  ASSIGN_OR_RETURN(
      const PagesDescription description,
      calls_.store.describe_pages(scan.id, give_way_to(calls_.live.scheduler(), progress)));
  v1::DescribePagesEvent event;
  *event.mutable_done() = to_wire(description);
  events_.push(std::move(event));
  return Status::ok();
}

bool DescribePagesCall::report_progress(std::string_view phase, double fraction) {
  v1::DescribePagesEvent event;
  event.mutable_progress()->set_phase(std::string(phase));
  event.mutable_progress()->set_fraction(fraction);
  events_.offer(std::move(event));
  return !cancelled_;
}

DescribeSheetsCall::DescribeSheetsCall(const CallContext& calls,
                                       const v1::DescribeSheetsRequest& request)
    : calls_(calls),
      request_(request),
      events_([this](const v1::DescribeSheetsEvent* event) { StartWrite(event); },
              [this](grpc::Status status) { Finish(std::move(status)); }) {}

void DescribeSheetsCall::begin() {
  calls_.executor.post([call = self()] { call->end(call->describe()); },
                       [call = self()](const Status& status) { call->end(status); });
}

Status DescribeSheetsCall::describe() {
  ASSIGN_OR_RETURN(const ScanInfo scan, calls_.store.find(request_.scan()));
  const Progress progress = [this](std::string_view phase, double fraction) {
    return report_progress(phase, fraction);
  };
  const Progress giving_way = give_way_to(calls_.live.scheduler(), progress);
  SeamLevelling seams;
  if (request_.has_session()) {
    ASSIGN_OR_RETURN(seams,
                     calls_.sessions.seams(request_.session(), scan.id, calls_.caller, giving_way));
  }
  ASSIGN_OR_RETURN(
      const SheetsDescription description,
      calls_.store.describe_sheets(scan.id, giving_way, {seams.amount, seams.free}, calls_.user));
  v1::DescribeSheetsEvent event;
  *event.mutable_done() = to_wire(description);
  events_.push(std::move(event));
  return Status::ok();
}

bool DescribeSheetsCall::report_progress(std::string_view phase, double fraction) {
  v1::DescribeSheetsEvent event;
  event.mutable_progress()->set_phase(std::string(phase));
  event.mutable_progress()->set_fraction(fraction);
  events_.offer(std::move(event));
  return !cancelled_;
}

}  // namespace burnish
