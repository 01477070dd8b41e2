#include "server/rpc/admission/call_guard.h"

#include <grpc/grpc_security_constants.h>

#include "common/base/text.h"
#include "server/process/log_context.h"
#include "server/rpc/admission/admission.h"
#include "server/rpc/admission/call_observer.h"

namespace burnish {
namespace {

/// The header in which a client names its user.
constexpr char kUserHeader[] = "burnish-user-bin";

std::string_view view(grpc::string_ref text) {
  return {text.data(), text.size()};
}

Proof proof_of(const grpc::CallbackServerContext& context, const grpc::AuthContext& connection) {
  Proof proof;
  const auto header = context.client_metadata().find("authorization");
  if (header != context.client_metadata().end()) proof.authorization = view(header->second);
  proof.certificate_common_name = gateway_certificate_of(context);
  const auto names = connection.FindPropertyValues(GRPC_X509_CN_PROPERTY_NAME);
  if (!names.empty()) proof.certificate_common_name = view(names.front());
  return proof;
}

Status refuse(const grpc::CallbackServerContext& context, const Status& status) {
  const LogContext request(request_id_of(context));
  report_refusal(method_of(context), peer_of(context), status);
  return status;
}

}  // namespace

Result<Identity> CallGuard::identify(const grpc::CallbackServerContext& context) const {
  const auto connection = context.auth_context();
  auto identity = guard_.identify(proof_of(context, *connection));
  return identity.is_ok() ? std::move(identity) : refuse(context, identity.status());
}

/// Returns the bounds that the server sets an identity in any session. Editors own the sessions
/// that they make.
static Caller bounded(const Identity& identity) {
  Caller caller(identity.user);
  if (identity.user.empty()) return caller;
  caller.is_admitted = true;
  caller.owns_server = identity.role == Role::kOwner;
  if (identity.role < Role::kEditor) caller.most = SessionRole::kViewer;
  return caller;
}

Result<Caller> CallGuard::caller_of(const grpc::CallbackServerContext& context) const {
  ASSIGN_OR_RETURN(const Identity identity,
                   guard_.identify(proof_of(context, *context.auth_context())));
  Caller caller = bounded(identity);
  const auto header = context.client_metadata().find(kUserHeader);
  if (header == context.client_metadata().end()) return caller;
  std::string name(view(header->second));
  RETURN_IF_ERROR(check_name("the user's name", name));
  if (!identity.user.empty() && identity.user != name)
    return refuse(context, {StatusCode::kPermissionDenied,
                            "user " + identity.user + " must not use the name '" + name + "'"});
  caller.user = std::move(name);
  return caller;
}

std::function<Status()> CallGuard::may_stay(const grpc::CallbackServerContext& context,
                                            const Identity& identity) const {
  if (identity.user.empty()) return {};
  const auto connection = context.auth_context();  // owns the certificate's data in the proof
  const Proof shown = proof_of(context, *connection);
  return [this, identity, token = std::string(shown.authorization),
          certificate = std::string(shown.certificate_common_name)]() -> Status {
    const auto now = guard_.identify({token, certificate});
    if (now.is_ok() && now.value() == identity) return Status::ok();
    return {StatusCode::kPermissionDenied,
            "the rights of user " + identity.user + " on this server have changed"};
  };
}

Result<CallGuard::Stream> CallGuard::admit_stream(const grpc::CallbackServerContext& context) {
  Stream stream;
  ASSIGN_OR_RETURN(stream.identity, identify(context));
  if (stream.identity.user.empty()) return stream;
  auto share = streams_.take("user " + stream.identity.user, 1);
  if (!share.is_ok()) return refuse(context, share.status());
  stream.share = std::move(share).value();
  return stream;
}

}  // namespace burnish
