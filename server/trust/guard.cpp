#include "server/trust/guard.h"

namespace burnish {

static Identity identity_of(const User& user) {
  return {user.name, user.role};
}

static Status unauthenticated(const std::string& message) {
  return {StatusCode::kUnauthenticated, message};
}

Result<Identity> Guard::check(std::string_view method, const Proof& proof) const {
  const auto needed = least_role(method);
  if (!needed) return unimplemented("this server has no RPC " + std::string(method));
  if (*needed == Role::kAnyone) return Identity{};
  if (closed_) return unavailable("the server is draining");
  ASSIGN_OR_RETURN(Identity identity, identify(proof));
  if (identity.role >= *needed) return identity;
  return Status(StatusCode::kPermissionDenied,
                "user " + identity.user + " is " + std::string(role_name(identity.role)) + "; " +
                    std::string(method) + " needs the role " + std::string(role_name(*needed)));
}

Result<Identity> Guard::identify(const Proof& proof) const {
  static constexpr std::string_view kScheme = "Bearer ";
  if (users_ == nullptr) return Identity{};
  const auto table = users_->get();
  if (!proof.authorization.empty()) {
    if (!proof.authorization.starts_with(kScheme))
      return unauthenticated("the authorization is no bearer token");
    const User* user = table->find_token(proof.authorization.substr(kScheme.size()));
    return user ? Result<Identity>(identity_of(*user))
                : unauthenticated("the token is not known here");
  }
  if (!proof.certificate_common_name.empty()) {
    const User* user = table->find_certificate(proof.certificate_common_name);
    return user ? Result<Identity>(identity_of(*user))
                : unauthenticated("no user has the certificate '" +
                                  std::string(proof.certificate_common_name) + "'");
  }
  return unauthenticated("the call has no token and no certificate");
}

}  // namespace burnish
