#include "server/rpc/calls/editing_service.h"

#include "common/wire/edit_wire.h"
#include "common/wire/history_wire.h"
#include "common/wire/measures_wire.h"
#include "common/wire/session_wire.h"
#include "server/rpc/calls/edit_call.h"
#include "server/rpc/calls/export_call.h"
#include "server/rpc/calls/upload_cell_fields_call.h"
#include "server/rpc/calls/value_calls.h"
#include "server/rpc/calls/watch_call.h"
#include "server/rpc/reactor/start_call.h"

namespace burnish {

grpc::ServerUnaryReactor* EditingService::OpenSession(grpc::CallbackServerContext* context,
                                                      const v1::OpenSessionRequest* request,
                                                      v1::OpenSessionResponse* response) {
  return answer(calls_, context, *request, [=, this](const Progress& progress) -> Status {
    ASSIGN_OR_RETURN(const SessionWish wish, from_wire(*request));
    ASSIGN_OR_RETURN(const Caller caller, calls_.guard.caller_of(*context));
    ASSIGN_OR_RETURN(const OpenedSession opened, calls_.sessions.open(wish, caller, progress));
    *response->mutable_session() = to_wire(opened.session);
    response->set_attached(opened.attached);
    return Status::ok();
  });
}

grpc::ServerUnaryReactor* EditingService::ListSessions(grpc::CallbackServerContext* context,
                                                       const v1::ListSessionsRequest* request,
                                                       v1::ListSessionsResponse* response) {
  return answer(calls_, context, *request, [this, response](const Progress&) {
    for (const SessionInfo& session : calls_.sessions.list())
      *response->add_sessions() = to_wire(session);
    return Status::ok();
  });
}

grpc::ServerUnaryReactor* EditingService::CloseSession(grpc::CallbackServerContext* context,
                                                       const v1::CloseSessionRequest* request,
                                                       v1::CloseSessionResponse*) {
  return answer(calls_, context, *request, [=, this](const Progress& progress) -> Status {
    ASSIGN_OR_RETURN(const Caller caller, calls_.guard.caller_of(*context));
    return calls_.sessions.close(request->session(), caller, progress);
  });
}

grpc::ServerUnaryReactor* EditingService::RenameSession(grpc::CallbackServerContext* context,
                                                        const v1::RenameSessionRequest* request,
                                                        v1::SessionInfo* response) {
  return answer(calls_, context, *request, [=, this](const Progress& progress) -> Status {
    RETURN_IF_ERROR(check_name("the session's name", request->name()));
    ASSIGN_OR_RETURN(const Caller caller, calls_.guard.caller_of(*context));
    ASSIGN_OR_RETURN(const SessionInfo session,
                     calls_.sessions.rename(request->session(), request->name(), caller, progress));
    *response = to_wire(session);
    return Status::ok();
  });
}

grpc::ServerUnaryReactor* EditingService::DeleteSession(grpc::CallbackServerContext* context,
                                                        const v1::DeleteSessionRequest* request,
                                                        v1::DeleteSessionResponse*) {
  return answer(calls_, context, *request, [=, this](const Progress& progress) -> Status {
    ASSIGN_OR_RETURN(const Caller caller, calls_.guard.caller_of(*context));
    return calls_.sessions.remove(request->session(), caller, progress);
  });
}

grpc::ServerUnaryReactor* EditingService::Apply(grpc::CallbackServerContext* context,
                                                const v1::ApplyRequest* request,
                                                v1::ApplyResponse* response) {
  return answer(calls_, context, *request, [=, this](const Progress& progress) -> Status {
    ASSIGN_OR_RETURN(const auto edits, edits_from_wire(*request));
    ASSIGN_OR_RETURN(const Caller caller, calls_.guard.caller_of(*context));
    ASSIGN_OR_RETURN(const ApplyOutcome outcome,
                     calls_.sessions.apply(request->session(), caller, edits, progress));
    *response = to_wire(outcome);
    return Status::ok();
  });
}

grpc::ServerReadReactor<grpc::ByteBuffer>* EditingService::UploadCellFields(
    grpc::CallbackServerContext* context, grpc::ByteBuffer* response) {
  return start_call<UploadCellFieldsCall>(calls_, context, *response);
}

grpc::ServerUnaryReactor* EditingService::GetHistory(grpc::CallbackServerContext* context,
                                                     const v1::GetHistoryRequest* request,
                                                     v1::GetHistoryResponse* response) {
  return answer(calls_, context, *request, [=, this](const Progress& progress) -> Status {
    ASSIGN_OR_RETURN(const HistoryWish wish, from_wire(*request));
    ASSIGN_OR_RETURN(const Caller caller, calls_.guard.caller_of(*context));
    ASSIGN_OR_RETURN(const HistoryPage page, calls_.sessions.history(wish, caller, progress));
    *response = to_wire(page);
    return Status::ok();
  });
}

grpc::ServerUnaryReactor* EditingService::ForkSession(grpc::CallbackServerContext* context,
                                                      const v1::ForkSessionRequest* request,
                                                      v1::ForkSessionResponse* response) {
  return answer(calls_, context, *request, [=, this](const Progress& progress) -> Status {
    ASSIGN_OR_RETURN(const ForkWish wish, from_wire(*request));
    ASSIGN_OR_RETURN(const Caller caller, calls_.guard.caller_of(*context));
    ASSIGN_OR_RETURN(const ForkedSession forked, calls_.sessions.fork(wish, caller, progress));
    *response->mutable_session() = to_wire(forked.session);
    response->set_emptied_edits(forked.emptied_edits);
    return Status::ok();
  });
}

grpc::ServerUnaryReactor* EditingService::GetPeople(grpc::CallbackServerContext* context,
                                                    const v1::GetPeopleRequest* request,
                                                    v1::People* response) {
  return answer(calls_, context, *request,
                [this, request, response](const Progress& progress) -> Status {
                  ASSIGN_OR_RETURN(const SessionPeople people,
                                   calls_.sessions.people(request->session(), progress));
                  *response = to_wire(people);
                  return Status::ok();
                });
}

grpc::ServerUnaryReactor* EditingService::SetRole(grpc::CallbackServerContext* context,
                                                  const v1::SetRoleRequest* request,
                                                  v1::SetRoleResponse*) {
  return answer(calls_, context, *request, [=, this](const Progress& progress) -> Status {
    ASSIGN_OR_RETURN(const SessionRole role, from_wire(request->role()));
    if (!request->user().empty()) RETURN_IF_ERROR(check_name("the user's name", request->user()));
    ASSIGN_OR_RETURN(const Caller caller, calls_.guard.caller_of(*context));
    return calls_.sessions.set_role(request->session(), caller, request->user(), role, progress);
  });
}

grpc::ServerUnaryReactor* EditingService::GetState(grpc::CallbackServerContext* context,
                                                   const v1::GetStateRequest* request,
                                                   v1::SessionState* response) {
  return answer(calls_, context, *request, [=, this](const Progress& progress) -> Status {
    ASSIGN_OR_RETURN(const Caller caller, calls_.guard.caller_of(*context));
    ASSIGN_OR_RETURN(const SessionState state,
                     calls_.sessions.state(request->session(), caller, progress));
    *response = to_wire(state);
    return Status::ok();
  });
}

grpc::ServerBidiReactor<grpc::ByteBuffer, grpc::ByteBuffer>* EditingService::Edit(
    grpc::CallbackServerContext* context) {
  return start_call<EditCall>(calls_, context, *context);
}

grpc::ServerWriteReactor<v1::ServerMessage>* EditingService::Watch(
    grpc::CallbackServerContext* context, const v1::WatchRequest* request) {
  return start_call<WatchCall>(calls_, context, *context, *request);
}

grpc::ServerWriteReactor<v1::Chunk>* EditingService::GetCells(grpc::CallbackServerContext* context,
                                                              const v1::GetCellsRequest* request) {
  return start_call<GetCellsCall>(calls_, context, *request);
}

grpc::ServerWriteReactor<v1::PageValues>* EditingService::GetPageValues(
    grpc::CallbackServerContext* context, const v1::GetPageValuesRequest* request) {
  return start_call<GetPageValuesCall>(calls_, context, *request);
}

grpc::ServerUnaryReactor* EditingService::GetDeviation(grpc::CallbackServerContext* context,
                                                       const v1::GetDeviationRequest* request,
                                                       v1::Deviation* response) {
  return answer(calls_, context, *request, [=, this](const Progress& progress) -> Status {
    ASSIGN_OR_RETURN(const Caller caller, calls_.guard.caller_of(*context));
    ASSIGN_OR_RETURN(const SessionDeviation measured,
                     calls_.sessions.deviation(request->session(), caller, progress));
    *response = to_wire(measured);
    return Status::ok();
  });
}

grpc::ServerUnaryReactor* EditingService::GetSection(grpc::CallbackServerContext* context,
                                                     const v1::GetSectionRequest* request,
                                                     v1::Section* response) {
  return answer(calls_, context, *request, [=, this](const Progress& progress) -> Status {
    ASSIGN_OR_RETURN(const SectionWish wish, from_wire(*request));
    ASSIGN_OR_RETURN(const Caller caller, calls_.guard.caller_of(*context));
    ASSIGN_OR_RETURN(const Section section, calls_.sessions.section(wish, caller, progress));
    *response = to_wire(section, wish.plane);
    return Status::ok();
  });
}

grpc::ServerWriteReactor<v1::ExportEvent>* EditingService::Export(
    grpc::CallbackServerContext* context, const v1::ExportRequest* request) {
  return start_call<ExportCall>(calls_, context, *request);
}

}  // namespace burnish
