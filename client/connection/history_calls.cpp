#include "client/connection/connection_state.h"
#include "common/wire/history_wire.h"
#include "common/wire/session_wire.h"

namespace burnish {

Result<std::vector<HistoryEntry>> Connection::history(const std::string& session) {
  std::vector<HistoryEntry> entries;
  for (bool complete = false; !complete;) {
    const HistoryWish wish{session, entries.empty() ? 0 : entries.back().number};
    v1::GetHistoryResponse response;
    RETURN_IF_ERROR(state_->call_owner([&](v1::Editing::Stub& owner, grpc::ClientContext& context) {
      return owner.GetHistory(&context, to_wire(wish), &response);
    }));
    ASSIGN_OR_RETURN(HistoryPage page, from_wire(response));
    complete = page.complete || page.entries.empty();
    entries.insert(entries.end(), page.entries.begin(), page.entries.end());
  }
  return entries;
}

Result<ForkedSession> Connection::fork_session(const ForkWish& wish) {
  v1::ForkSessionResponse response;
  RETURN_IF_ERROR(state_->call_owner([&](v1::Editing::Stub& owner, grpc::ClientContext& context) {
    return owner.ForkSession(&context, to_wire(wish), &response);
  }));
  ASSIGN_OR_RETURN(SessionInfo session, from_wire(response.session()));
  return ForkedSession{std::move(session), response.emptied_edits()};
}

Result<SessionPeople> Connection::people(const std::string& session) {
  v1::GetPeopleRequest request;
  request.set_session(session);
  v1::People response;
  RETURN_IF_ERROR(state_->call_owner([&](v1::Editing::Stub& owner, grpc::ClientContext& context) {
    state_->set_deadline(context);
    return owner.GetPeople(&context, request, &response);
  }));
  return from_wire(response);
}

Status Connection::set_role(const std::string& session, const std::string& user, SessionRole role) {
  v1::SetRoleRequest request;
  request.set_session(session);
  request.set_user(user);
  request.set_role(to_wire(role));
  v1::SetRoleResponse response;
  return state_->call_owner([&](v1::Editing::Stub& owner, grpc::ClientContext& context) {
    state_->set_deadline(context);
    return owner.SetRole(&context, request, &response);
  });
}

}  // namespace burnish
