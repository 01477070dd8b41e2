#include "server/trust/secret.h"

#include <array>

#include <openssl/crypto.h>
#include <openssl/rand.h>

#include "common/base/check.h"
#include "common/base/text.h"

namespace burnish {

std::string make_secret() {
  std::array<std::byte, 32> bytes;
  BURNISH_CHECK(RAND_bytes(reinterpret_cast<unsigned char*>(bytes.data()), bytes.size()) == 1,
                "OpenSSL has no random bytes");
  return to_hex(bytes);
}

bool is_same_secret(std::string_view a, std::string_view b) {
  return !a.empty() && a.size() == b.size() && CRYPTO_memcmp(a.data(), b.data(), a.size()) == 0;
}

}  // namespace burnish
