#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/base/status.h"
#include "server/trust/role.h"

namespace burnish {

using TokenHash = std::array<unsigned char, 32>;  ///< SHA-256

/// Somebody who may call. A token is kept as its hash alone: tokens are 32 random bytes, so that
/// no list of likely ones helps against the hash.
struct User {
  std::string name;
  Role role = Role::kViewer;
  std::optional<TokenHash> token_hash;
  std::string certificate;  ///< common name of a client certificate; empty: none
};

class UserTable {
 public:
  explicit UserTable(std::vector<User> users) : users_(std::move(users)) {}

  /// Null when nobody has the token. Takes the same time for every token.
  const User* find_token(std::string_view token) const;

  /// Null when no user has a certificate of this name. Needs: a certificate that was verified.
  const User* find_certificate(std::string_view common_name) const;

  const std::vector<User>& users() const { return users_; }

 private:
  std::vector<User> users_;
};

TokenHash hash_token(std::string_view token);

/// Reads a TOML file of users:
///
///     [[user]]
///     name = "anna"                 # unique
///     role = "editor"               # viewer, editor or owner
///     token_sha256 = "9f86d0..."    # 64 hexadecimal digits; and, or:
///     certificate = "anna"          # common name of the client certificate
///
/// Fails: not_found; failed_precondition when everybody can write the file; invalid_argument naming
/// file, line, key and value.
Result<UserTable> read_users_file(const std::filesystem::path& path);

}  // namespace burnish
