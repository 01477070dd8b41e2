#include "server/trust/guard.h"

#include <optional>
#include <strings.h>

namespace burnish {

static Identity identity_of(const User& user) {
  return {user.name, user.role};
}

static Status unauthenticated(const std::string& message) {
  return {StatusCode::kUnauthenticated, message};
}

/// Returns the token of "Bearer TOKEN"; the scheme's name may have any case (RFC 9110, section
/// 11.1).
static std::optional<std::string_view> bearer_token(std::string_view authorization) {
  static constexpr std::string_view kScheme = "bearer ";
  const bool is_bearer = authorization.size() >= kScheme.size() &&
                         strncasecmp(authorization.data(), kScheme.data(), kScheme.size()) == 0;
  return is_bearer ? std::optional(authorization.substr(kScheme.size())) : std::nullopt;
}

Result<Identity> Guard::check(std::string_view method, const Proof& proof) const {
  const auto needed = least_role(method);
  if (!needed)
    return unimplemented("this server has no RPC " + std::string(method) +
                         ": client and server are of different versions");
  if (*needed == Role::kAnyone) return Identity{};
  if (closed_) return unavailable("the server is draining");
  ASSIGN_OR_RETURN(Identity identity, identify(proof));
  if (identity.role >= *needed) return identity;
  return Status(StatusCode::kPermissionDenied,
                "user " + identity.user + " is " + std::string(role_name(identity.role)) + "; " +
                    std::string(method) + " needs the role " + std::string(role_name(*needed)));
}

Result<Identity> Guard::identify(const Proof& proof) const {
  if (users_ == nullptr) return Identity{};
  const auto table = users_->get();
  if (!proof.authorization.empty()) {
    const auto token = bearer_token(proof.authorization);
    if (!token) return unauthenticated("the authorization is not a bearer token");
    const User* user = table->find_token(*token);
    return user ? Result<Identity>(identity_of(*user))
                : unauthenticated("the server does not know the token");
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
