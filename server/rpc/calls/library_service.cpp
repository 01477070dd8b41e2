#include "server/rpc/calls/library_service.h"

#include <spdlog/spdlog.h>

#include "common/base/text.h"
#include "common/wire/format_wire.h"
#include "common/wire/library_wire.h"
#include "server/rpc/calls/describe_calls.h"
#include "server/rpc/calls/fetch_calls.h"
#include "server/rpc/calls/import_call.h"
#include "server/rpc/reactor/event_call.h"
#include "server/rpc/reactor/start_call.h"

namespace burnish {

namespace {

/// Library.PrepareScan: progress while the store prepares, then the scan.
class PrepareCall final : public EventCall<PrepareCall, v1::PrepareScanRequest, v1::PrepareEvent> {
 public:
  using EventCall::EventCall;

  Status run() {
    ASSIGN_OR_RETURN(const PreparedKey key,
                     prepared_key_from_wire(request_.depth(), request_.curvature_radius()));
    ASSIGN_OR_RETURN(const ScanInfo scan, calls_.store.find(request_.scan()));
    RETURN_IF_ERROR(
        calls_.store.prepare_scan(scan.id, resolve(key, scan), progress(), calls_.user));
    ASSIGN_OR_RETURN(const ScanInfo prepared, calls_.store.find(scan.id));
    v1::PrepareEvent event;
    *event.mutable_done() = to_wire(prepared);
    events_.push(std::move(event));
    return Status::ok();
  }
};

/// Library.ProposeEdges: progress while the store measures the scan, then what it proposes.
class ProposeEdgesCall final
    : public EventCall<ProposeEdgesCall, v1::ProposeEdgesRequest, v1::ProposeEdgesEvent> {
 public:
  using EventCall::EventCall;

  Status run() {
    ASSIGN_OR_RETURN(const ScanInfo scan, calls_.store.find(request_.scan()));
    ASSIGN_OR_RETURN(const EdgeProposal proposal, calls_.store.propose_edges(scan.id, progress()));
    v1::ProposeEdgesEvent event;
    *event.mutable_done() = to_wire(proposal);
    events_.push(std::move(event));
    return Status::ok();
  }
};

}  // namespace

grpc::ServerBidiReactor<grpc::ByteBuffer, grpc::ByteBuffer>* LibraryService::Import(
    grpc::CallbackServerContext* context) {
  return start_call<ImportCall>(calls_, context);
}

grpc::ServerUnaryReactor* LibraryService::ListScans(grpc::CallbackServerContext* context,
                                                    const v1::ListScansRequest* request,
                                                    v1::ListScansResponse* response) {
  return answer(calls_, context, *request, [this, response](const Progress&) {
    const Status fresh = calls_.store.refresh();
    if (!fresh.is_ok()) spdlog::warn("the list of scans is old: {}", fresh.message());
    for (const ScanInfo& scan : calls_.store.list()) *response->add_scans() = to_wire(scan);
    return Status::ok();
  });
}

grpc::ServerUnaryReactor* LibraryService::DescribeScan(grpc::CallbackServerContext* context,
                                                       const v1::DescribeScanRequest* request,
                                                       v1::ScanDescription* response) {
  return answer(calls_, context, *request, [this, request, response](const Progress&) -> Status {
    ASSIGN_OR_RETURN(const PreparedKey key, prepared_key_from_wire(request->depth(), 0));
    ASSIGN_OR_RETURN(const ScanDescription description,
                     calls_.store.describe(request->scan(), key.depth));
    *response = to_wire(description);
    return Status::ok();
  });
}

grpc::ServerWriteReactor<v1::PrepareEvent>* LibraryService::PrepareScan(
    grpc::CallbackServerContext* context, const v1::PrepareScanRequest* request) {
  return start_call<PrepareCall>(calls_, context, *request);
}

grpc::ServerWriteReactor<v1::DescribePagesEvent>* LibraryService::DescribePages(
    grpc::CallbackServerContext* context, const v1::DescribePagesRequest* request) {
  return start_call<DescribePagesCall>(calls_, context, *request);
}

grpc::ServerWriteReactor<v1::FetchPagesEvent>* LibraryService::FetchPages(
    grpc::CallbackServerContext* context, const v1::FetchPagesRequest* request) {
  return start_call<FetchPagesCall>(calls_, context, *request);
}

grpc::ServerWriteReactor<v1::DescribeSheetsEvent>* LibraryService::DescribeSheets(
    grpc::CallbackServerContext* context, const v1::DescribeSheetsRequest* request) {
  return start_call<DescribeSheetsCall>(calls_, context, *request);
}

grpc::ServerWriteReactor<v1::FetchSheetsEvent>* LibraryService::FetchSheets(
    grpc::CallbackServerContext* context, const v1::FetchSheetsRequest* request) {
  return start_call<FetchSheetsCall>(calls_, context, *request);
}

grpc::ServerWriteReactor<v1::ProposeEdgesEvent>* LibraryService::ProposeEdges(
    grpc::CallbackServerContext* context, const v1::ProposeEdgesRequest* request) {
  return start_call<ProposeEdgesCall>(calls_, context, *request);
}

grpc::ServerUnaryReactor* LibraryService::RenameScan(grpc::CallbackServerContext* context,
                                                     const v1::RenameScanRequest* request,
                                                     v1::ScanInfo* response) {
  return answer(calls_, context, *request, [this, request, response](const Progress&) -> Status {
    RETURN_IF_ERROR(check_name("the scan's name", request->name()));
    ASSIGN_OR_RETURN(const ScanInfo scan, calls_.store.rename(request->scan(), request->name()));
    *response = to_wire(scan);
    return Status::ok();
  });
}

grpc::ServerUnaryReactor* LibraryService::SetScanUnit(grpc::CallbackServerContext* context,
                                                      const v1::SetScanUnitRequest* request,
                                                      v1::ScanInfo* response) {
  return answer(calls_, context, *request, [this, request, response](const Progress&) -> Status {
    RETURN_IF_ERROR(check_unit(request->unit()));
    ASSIGN_OR_RETURN(const ScanInfo scan, calls_.store.set_unit(request->scan(), request->unit()));
    *response = to_wire(scan);
    return Status::ok();
  });
}

grpc::ServerUnaryReactor* LibraryService::DeleteScan(grpc::CallbackServerContext* context,
                                                     const v1::DeleteScanRequest* request,
                                                     v1::DeleteScanResponse* response) {
  return answer(calls_, context, *request, [this, request, response](const Progress&) -> Status {
    ASSIGN_OR_RETURN(const std::string id, calls_.sessions.delete_scan(request->scan()));
    spdlog::info("scan {} deleted", short_id(id));
    response->set_id(id);
    return Status::ok();
  });
}

}  // namespace burnish
