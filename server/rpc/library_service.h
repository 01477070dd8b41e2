#pragma once

#include "burnish/v1/library.grpc.pb.h"
#include "server/rpc/call_context.h"

namespace burnish {

/// burnish.v1.Library over the mesh store: adapts messages, and nothing else.
class LibraryService final : public v1::Library::CallbackService {
 public:
  explicit LibraryService(const CallContext& calls) : calls_(calls) {}

  grpc::ServerBidiReactor<v1::ImportRequest, v1::ImportEvent>* Import(
      grpc::CallbackServerContext* context) override;
  grpc::ServerUnaryReactor* ListScans(grpc::CallbackServerContext* context,
                                      const v1::ListScansRequest* request,
                                      v1::ListScansResponse* response) override;
  grpc::ServerUnaryReactor* DescribeScan(grpc::CallbackServerContext* context,
                                         const v1::DescribeScanRequest* request,
                                         v1::ScanDescription* response) override;
  grpc::ServerWriteReactor<v1::PrepareEvent>* PrepareScan(
      grpc::CallbackServerContext* context, const v1::PrepareScanRequest* request) override;
  grpc::ServerWriteReactor<v1::FetchViewEvent>* FetchView(
      grpc::CallbackServerContext* context, const v1::FetchViewRequest* request) override;
  grpc::ServerUnaryReactor* DeleteScan(grpc::CallbackServerContext* context,
                                       const v1::DeleteScanRequest* request,
                                       v1::DeleteScanResponse* response) override;

 private:
  const CallContext calls_;
};

}  // namespace burnish
