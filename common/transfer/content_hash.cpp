#include "common/transfer/content_hash.h"

#include <span>

#include <openssl/evp.h>

#include "common/base/check.h"
#include "common/base/text.h"

namespace burnish {

struct ContentHash::Context {
  Context() : digest(EVP_MD_CTX_new()) {
    BURNISH_CHECK(digest && EVP_DigestInit_ex(digest, EVP_sha256(), nullptr) == 1,
                  "SHA-256 is in every OpenSSL");
  }
  ~Context() { EVP_MD_CTX_free(digest); }
  EVP_MD_CTX* digest;
};

ContentHash::ContentHash() : context_(std::make_unique<Context>()) {}
ContentHash::~ContentHash() = default;
ContentHash::ContentHash(ContentHash&&) noexcept = default;
ContentHash& ContentHash::operator=(ContentHash&&) noexcept = default;

void ContentHash::update(std::string_view bytes) {
  EVP_DigestUpdate(context_->digest, bytes.data(), bytes.size());
}

std::string ContentHash::finish() {
  unsigned char bytes[EVP_MAX_MD_SIZE];
  unsigned int size = 0;
  EVP_DigestFinal_ex(context_->digest, bytes, &size);
  return to_hex(std::as_bytes(std::span(bytes, size)));
}

}  // namespace burnish
