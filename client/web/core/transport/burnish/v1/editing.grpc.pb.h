#pragma once

#include <grpcpp/grpcpp.h>

#include "burnish/v1/editing.pb.h"

namespace burnish::v1 {

/// The calls of sessions but Edit, as gRPC's stub has them.
class Editing {
 public:
  class Stub {
   public:
#define BURNISH_CALL(name, Question, Answer)                                                  \
  grpc::Status name(grpc::ClientContext* context, const Question& question, Answer* answer) { \
    return grpc::call_once("burnish.v1.Editing/" #name, context, question, answer);           \
  }
#define BURNISH_CALL_FOR_MANY(name, Question, Answer)                                   \
  std::unique_ptr<grpc::ClientReader<Answer>> name(grpc::ClientContext* context,        \
                                                   const Question& question) {          \
    return grpc::call_for_many<Answer>("burnish.v1.Editing/" #name, context, question); \
  }
    BURNISH_CALL(OpenSession, OpenSessionRequest, OpenSessionResponse)
    BURNISH_CALL(ListSessions, ListSessionsRequest, ListSessionsResponse)
    BURNISH_CALL(CloseSession, CloseSessionRequest, CloseSessionResponse)
    BURNISH_CALL(DeleteSession, DeleteSessionRequest, DeleteSessionResponse)
    BURNISH_CALL(RenameSession, RenameSessionRequest, SessionInfo)
    BURNISH_CALL(Apply, ApplyRequest, ApplyResponse)
    BURNISH_CALL(GetHistory, GetHistoryRequest, GetHistoryResponse)
    BURNISH_CALL(ForkSession, ForkSessionRequest, ForkSessionResponse)
    BURNISH_CALL(GetPeople, GetPeopleRequest, People)
    BURNISH_CALL(SetRole, SetRoleRequest, SetRoleResponse)
    BURNISH_CALL(GetState, GetStateRequest, SessionState)
    BURNISH_CALL(GetDeviation, GetDeviationRequest, Deviation)
    BURNISH_CALL(GetSection, GetSectionRequest, Section)
    BURNISH_CALL_FOR_MANY(GetCells, GetCellsRequest, Chunk)
    BURNISH_CALL_FOR_MANY(GetPageValues, GetPageValuesRequest, PageValues)
    BURNISH_CALL_FOR_MANY(Export, ExportRequest, ExportEvent)
#undef BURNISH_CALL
#undef BURNISH_CALL_FOR_MANY
    std::unique_ptr<grpc::AnsweredWriter<UploadCellFieldsRequest, ApplyResponse>> UploadCellFields(
        grpc::ClientContext* context, ApplyResponse* answer) {
      return std::make_unique<grpc::AnsweredWriter<UploadCellFieldsRequest, ApplyResponse>>(
          context->begin("burnish.v1.Editing/UploadCellFields"), answer);
    }
  };

  static std::unique_ptr<Stub> NewStub(const std::shared_ptr<grpc::Channel>&) {
    return std::make_unique<Stub>();
  }
};

}  // namespace burnish::v1
