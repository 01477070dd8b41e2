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

/// A user of the server. Keeps only the hash of the token. Tokens are 32 random bytes, so a list of
/// likely tokens does not help against the hash.
struct User {
  std::string name;
  Role role = Role::kViewer;
  std::optional<TokenHash> token_hash;
  std::string certificate;  ///< common name of a client certificate; empty for none
};

class UserTable {
 public:
  explicit UserTable(std::vector<User> users) : users_(std::move(users)) {}

  /// Returns null if nobody has the token. Takes the same time for every token.
  const User* find_token(std::string_view token) const;

  /// Returns null if no user has a certificate of this name. Needs: a verified certificate.
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
/// Fails: not_found; failed_precondition if everybody can write the file; invalid_argument that
/// names file, line, key and value.
Result<UserTable> read_users_file(const std::filesystem::path& path);

}  // namespace burnish
