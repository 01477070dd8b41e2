#pragma once

#include <grpcpp/grpcpp.h>

#include "burnish/v1/library.pb.h"

namespace burnish::v1 {

/// The calls of the library, as gRPC's stub has them.
class Library {
 public:
  class Stub {
   public:
#define BURNISH_CALL(name, Question, Answer)                                                  \
  grpc::Status name(grpc::ClientContext* context, const Question& question, Answer* answer) { \
    return grpc::call_once("burnish.v1.Library/" #name, context, question, answer);           \
  }
#define BURNISH_CALL_FOR_MANY(name, Question, Answer)                                   \
  std::unique_ptr<grpc::ClientReader<Answer>> name(grpc::ClientContext* context,        \
                                                   const Question& question) {          \
    return grpc::call_for_many<Answer>("burnish.v1.Library/" #name, context, question); \
  }
    BURNISH_CALL(ListScans, ListScansRequest, ListScansResponse)
    BURNISH_CALL(DescribeScan, DescribeScanRequest, ScanDescription)
    BURNISH_CALL(DeleteScan, DeleteScanRequest, DeleteScanResponse)
    BURNISH_CALL(RenameScan, RenameScanRequest, ScanInfo)
    BURNISH_CALL(SetScanUnit, SetScanUnitRequest, ScanInfo)
    BURNISH_CALL_FOR_MANY(PrepareScan, PrepareScanRequest, PrepareEvent)
    BURNISH_CALL_FOR_MANY(DescribePages, DescribePagesRequest, DescribePagesEvent)
    BURNISH_CALL_FOR_MANY(DescribeSheets, DescribeSheetsRequest, DescribeSheetsEvent)
    BURNISH_CALL_FOR_MANY(FetchSheets, FetchSheetsRequest, FetchSheetsEvent)
    BURNISH_CALL_FOR_MANY(ProposeEdges, ProposeEdgesRequest, ProposeEdgesEvent)
    BURNISH_CALL_FOR_MANY(FetchPages, FetchPagesRequest, FetchPagesEvent)
#undef BURNISH_CALL
#undef BURNISH_CALL_FOR_MANY
    std::unique_ptr<grpc::ClientReaderWriter<ImportRequest, ImportEvent>> Import(
        grpc::ClientContext* context) {
      return std::make_unique<grpc::ClientReaderWriter<ImportRequest, ImportEvent>>(
          context->begin("burnish.v1.Library/Import"));
    }
  };

  static std::unique_ptr<Stub> NewStub(const std::shared_ptr<grpc::Channel>&) {
    return std::make_unique<Stub>();
  }
};

}  // namespace burnish::v1
