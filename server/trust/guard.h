#pragma once

#include <atomic>
#include <memory>
#include <string>
#include <string_view>

#include "common/base/status.h"
#include "server/trust/reloaded.h"
#include "server/trust/users.h"

namespace burnish {

/// Who calls. Without a table of users everybody is the owner.
struct Identity {
  std::string user;  ///< empty: nobody was asked
  Role role = Role::kOwner;
  bool operator==(const Identity&) const = default;
};

/// What a call shows of its caller.
struct Proof {
  std::string_view authorization;            ///< the header of that name; empty: none
  std::string_view certificate_common_name;  ///< of a verified client certificate; empty: none
};

/// Decides who may call what. Thread-safe.
class Guard {
 public:
  /// `users` may be null: nobody is asked who he is. Needs: it outlives the guard.
  explicit Guard(const Reloaded<UserTable>* users) : users_(users) {}

  /// Fails: unauthenticated (no proof, or a wrong one), permission_denied, unimplemented (an RPC
  /// that has no role), unavailable (draining). Messages never repeat a token.
  Result<Identity> check(std::string_view method, const Proof& proof) const;

  /// Who that is, whatever he wants. Fails: unauthenticated.
  Result<Identity> identify(const Proof& proof) const;

  /// From now on nobody is let in, but for those whom everybody lets in: health.
  void close() { closed_ = true; }

 private:
  const Reloaded<UserTable>* users_;
  std::atomic<bool> closed_{false};
};

}  // namespace burnish
