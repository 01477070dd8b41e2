#pragma once

#include "burnish/v1/library.grpc.pb.h"
#include "server/rpc/reactor/call_context.h"
#include "server/rpc/reactor/with_calls.h"

namespace burnish {

using LibraryCalls = WithCalls<
    v1::Library::Service, v1::Library::WithRawCallbackMethod_Import,
    v1::Library::WithCallbackMethod_ListScans, v1::Library::WithCallbackMethod_DescribeScan,
    v1::Library::WithCallbackMethod_PrepareScan, v1::Library::WithCallbackMethod_DescribePages,
    v1::Library::WithCallbackMethod_FetchPages, v1::Library::WithCallbackMethod_DescribeSheets,
    v1::Library::WithCallbackMethod_FetchSheets, v1::Library::WithCallbackMethod_ProposeEdges,
    v1::Library::WithCallbackMethod_RenameScan, v1::Library::WithCallbackMethod_SetScanUnit,
    v1::Library::WithCallbackMethod_DeleteScan>::Type;

/// burnish.v1.Library over the mesh store; only converts messages.
class LibraryService final : public LibraryCalls {
 public:
  explicit LibraryService(const CallContext& calls) : calls_(calls) {}

  grpc::ServerBidiReactor<grpc::ByteBuffer, grpc::ByteBuffer>* Import(
      grpc::CallbackServerContext* context) override;
  grpc::ServerUnaryReactor* ListScans(grpc::CallbackServerContext* context,
                                      const v1::ListScansRequest* request,
                                      v1::ListScansResponse* response) override;
  grpc::ServerUnaryReactor* DescribeScan(grpc::CallbackServerContext* context,
                                         const v1::DescribeScanRequest* request,
                                         v1::ScanDescription* response) override;
  grpc::ServerWriteReactor<v1::PrepareEvent>* PrepareScan(
      grpc::CallbackServerContext* context, const v1::PrepareScanRequest* request) override;
  grpc::ServerWriteReactor<v1::DescribePagesEvent>* DescribePages(
      grpc::CallbackServerContext* context, const v1::DescribePagesRequest* request) override;
  grpc::ServerWriteReactor<v1::FetchPagesEvent>* FetchPages(
      grpc::CallbackServerContext* context, const v1::FetchPagesRequest* request) override;
  grpc::ServerWriteReactor<v1::DescribeSheetsEvent>* DescribeSheets(
      grpc::CallbackServerContext* context, const v1::DescribeSheetsRequest* request) override;
  grpc::ServerWriteReactor<v1::FetchSheetsEvent>* FetchSheets(
      grpc::CallbackServerContext* context, const v1::FetchSheetsRequest* request) override;
  grpc::ServerWriteReactor<v1::ProposeEdgesEvent>* ProposeEdges(
      grpc::CallbackServerContext* context, const v1::ProposeEdgesRequest* request) override;
  grpc::ServerUnaryReactor* RenameScan(grpc::CallbackServerContext* context,
                                       const v1::RenameScanRequest* request,
                                       v1::ScanInfo* response) override;
  grpc::ServerUnaryReactor* SetScanUnit(grpc::CallbackServerContext* context,
                                        const v1::SetScanUnitRequest* request,
                                        v1::ScanInfo* response) override;
  grpc::ServerUnaryReactor* DeleteScan(grpc::CallbackServerContext* context,
                                       const v1::DeleteScanRequest* request,
                                       v1::DeleteScanResponse* response) override;

 private:
  const CallContext calls_;
};

}  // namespace burnish
