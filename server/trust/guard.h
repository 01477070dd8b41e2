#pragma once

#include <atomic>
#include <memory>
#include <string>
#include <string_view>

#include "common/base/status.h"
#include "server/trust/reloaded.h"
#include "server/trust/users.h"

namespace burnish {

/// The caller. Without a table of users everybody is the owner.
struct Identity {
  std::string user;  ///< empty without authentication
  Role role = Role::kOwner;
  bool operator==(const Identity&) const = default;
};

/// The proof of identity in a call.
struct Proof {
  std::string_view authorization;            ///< the header of that name; empty for none
  std::string_view certificate_common_name;  ///< of a verified client certificate; empty for none
};

/// Decides who may make which call. Thread-safe.
class Guard {
 public:
  /// `users` may be null: no authentication. Needs: it outlives the guard.
  explicit Guard(const Reloaded<UserTable>* users) : users_(users) {}

  /// Fails: unauthenticated (no proof, or a wrong one), permission_denied, unimplemented (an RPC
  /// that has no role), unavailable (draining). Messages never repeat a token.
  Result<Identity> check(std::string_view method, const Proof& proof) const;

  /// Returns the identity, whatever the call. Fails: unauthenticated.
  Result<Identity> identify(const Proof& proof) const;

  /// From now on admits nobody, except to calls that are open to everybody: health.
  void close() { closed_ = true; }

 private:
  const Reloaded<UserTable>* users_;
  std::atomic<bool> closed_{false};
};

}  // namespace burnish
