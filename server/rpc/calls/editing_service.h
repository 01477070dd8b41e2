#pragma once

#include "burnish/v1/editing.grpc.pb.h"
#include "server/rpc/reactor/call_context.h"
#include "server/rpc/reactor/with_calls.h"

namespace burnish {

using EditingCalls = WithCalls<
    v1::Editing::Service, v1::Editing::WithRawCallbackMethod_Edit,
    v1::Editing::WithRawCallbackMethod_UploadCellFields,
    v1::Editing::WithCallbackMethod_OpenSession, v1::Editing::WithCallbackMethod_ListSessions,
    v1::Editing::WithCallbackMethod_CloseSession, v1::Editing::WithCallbackMethod_RenameSession,
    v1::Editing::WithCallbackMethod_DeleteSession, v1::Editing::WithCallbackMethod_Apply,
    v1::Editing::WithCallbackMethod_GetHistory, v1::Editing::WithCallbackMethod_ForkSession,
    v1::Editing::WithCallbackMethod_GetPeople, v1::Editing::WithCallbackMethod_SetRole,
    v1::Editing::WithCallbackMethod_GetState, v1::Editing::WithCallbackMethod_Watch,
    v1::Editing::WithCallbackMethod_GetCells, v1::Editing::WithCallbackMethod_GetPageValues,
    v1::Editing::WithCallbackMethod_GetDeviation, v1::Editing::WithCallbackMethod_GetSection,
    v1::Editing::WithCallbackMethod_Export>::Type;

/// burnish.v1.Editing over the session manager; only converts messages.
class EditingService final : public EditingCalls {
 public:
  explicit EditingService(const CallContext& calls) : calls_(calls) {}

  grpc::ServerUnaryReactor* OpenSession(grpc::CallbackServerContext* context,
                                        const v1::OpenSessionRequest* request,
                                        v1::OpenSessionResponse* response) override;
  grpc::ServerUnaryReactor* ListSessions(grpc::CallbackServerContext* context,
                                         const v1::ListSessionsRequest* request,
                                         v1::ListSessionsResponse* response) override;
  grpc::ServerUnaryReactor* CloseSession(grpc::CallbackServerContext* context,
                                         const v1::CloseSessionRequest* request,
                                         v1::CloseSessionResponse* response) override;
  grpc::ServerUnaryReactor* RenameSession(grpc::CallbackServerContext* context,
                                          const v1::RenameSessionRequest* request,
                                          v1::SessionInfo* response) override;
  grpc::ServerUnaryReactor* DeleteSession(grpc::CallbackServerContext* context,
                                          const v1::DeleteSessionRequest* request,
                                          v1::DeleteSessionResponse* response) override;
  grpc::ServerUnaryReactor* Apply(grpc::CallbackServerContext* context,
                                  const v1::ApplyRequest* request,
                                  v1::ApplyResponse* response) override;
  grpc::ServerReadReactor<grpc::ByteBuffer>* UploadCellFields(grpc::CallbackServerContext* context,
                                                              grpc::ByteBuffer* response) override;
  grpc::ServerUnaryReactor* GetHistory(grpc::CallbackServerContext* context,
                                       const v1::GetHistoryRequest* request,
                                       v1::GetHistoryResponse* response) override;
  grpc::ServerUnaryReactor* ForkSession(grpc::CallbackServerContext* context,
                                        const v1::ForkSessionRequest* request,
                                        v1::ForkSessionResponse* response) override;
  grpc::ServerUnaryReactor* GetPeople(grpc::CallbackServerContext* context,
                                      const v1::GetPeopleRequest* request,
                                      v1::People* response) override;
  grpc::ServerUnaryReactor* SetRole(grpc::CallbackServerContext* context,
                                    const v1::SetRoleRequest* request,
                                    v1::SetRoleResponse* response) override;
  grpc::ServerUnaryReactor* GetState(grpc::CallbackServerContext* context,
                                     const v1::GetStateRequest* request,
                                     v1::SessionState* response) override;
  grpc::ServerBidiReactor<grpc::ByteBuffer, grpc::ByteBuffer>* Edit(
      grpc::CallbackServerContext* context) override;
  grpc::ServerWriteReactor<v1::ServerMessage>* Watch(grpc::CallbackServerContext* context,
                                                     const v1::WatchRequest* request) override;
  grpc::ServerWriteReactor<v1::Chunk>* GetCells(grpc::CallbackServerContext* context,
                                                const v1::GetCellsRequest* request) override;
  grpc::ServerWriteReactor<v1::PageValues>* GetPageValues(
      grpc::CallbackServerContext* context, const v1::GetPageValuesRequest* request) override;
  grpc::ServerUnaryReactor* GetDeviation(grpc::CallbackServerContext* context,
                                         const v1::GetDeviationRequest* request,
                                         v1::Deviation* response) override;
  grpc::ServerUnaryReactor* GetSection(grpc::CallbackServerContext* context,
                                       const v1::GetSectionRequest* request,
                                       v1::Section* response) override;
  grpc::ServerWriteReactor<v1::ExportEvent>* Export(grpc::CallbackServerContext* context,
                                                    const v1::ExportRequest* request) override;

 private:
  const CallContext calls_;
};

}  // namespace burnish
