#include "server/trust/users.h"

#include <openssl/crypto.h>
#include <openssl/sha.h>

namespace burnish {

TokenHash hash_token(std::string_view token) {
  TokenHash hash;
  SHA256(reinterpret_cast<const unsigned char*>(token.data()), token.size(), hash.data());
  return hash;
}

const User* UserTable::find_token(std::string_view token) const {
  const TokenHash hash = hash_token(token);
  const User* found = nullptr;
  for (const User& user : users_)  // no early end: the time must not depend on the token
    if (user.token_hash && CRYPTO_memcmp(hash.data(), user.token_hash->data(), hash.size()) == 0)
      found = &user;
  return found;
}

const User* UserTable::find_certificate(std::string_view common_name) const {
  for (const User& user : users_)
    if (!user.certificate.empty() && user.certificate == common_name) return &user;
  return nullptr;
}

}  // namespace burnish
